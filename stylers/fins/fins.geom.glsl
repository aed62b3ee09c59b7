// What:   a fin, a quad along an edge between a front and a back face, or along an open edge.
// Inputs: triangles with adjacency, corners 0, 2, 4; across the side that begins at a corner the
//         next one, or that corner again where nothing is. Or one side (LINES): the third corner,
//         both ends, the vertex across. stroke.glsl.
// Source: Rideout 2010, "Basic Fins", "The Spine Test", "Mind the Gap!". His facing test is the z
//         of a cross product on the screen; here it is taken before projection, so that what lies
//         behind the viewer counts right.

#ifdef LINES
layout(lines_adjacency) in;
layout(triangle_strip, max_vertices = 4) out;
#else
layout(triangles_adjacency) in;
layout(triangle_strip, max_vertices = 12) out;
#endif

in vec3 place[];
flat in int number[];

uniform float half_width;  // pixels
uniform float overhang;    // share of its length by which a fin goes on at both ends
uniform int joints;        // ROUND or not
uniform int kinds;         // bits of those that are drawn: CONTOURS, OPEN
uniform int apart;         // 1: short fins have a shader of their own (SHORT_FINS)

#ifdef SHORT_FINS
flat out float edge;            // its length, pixels
#endif
noperspective out vec3 reach;   // pixels along the edge from a, and off it; depth of the spine

const float SHARP = -0.8660254;  // cosine of 150 degrees between the faces
const float SHORT = 4.0;         // pixels: `seen` asks no further. One answer holds for all of
                                 // such a fin, and it is given here (SHORT_FINS)
const int ROUND_JOINTS = 2;
const int CONTOURS = 1, OPEN = 2;
const int OPEN_SIDE = RING + 16 * (BOUNDARY - 3);  // glshim/model/lines.py, in_group

// Whether a triangle turns counter-clockwise for the viewer.
bool is_front(int a, int b, int c) { return faces(place[a], place[b], place[c], eye); }

// How the two triangles meet, for the spine test; both say the same. Only what has an outside is
// hollow anywhere: of a sheet the nearer triangle is seen, and that folds away.
int kind_of(int a, int b, int c, int across) {
    vec3 own = cross(place[b] - place[a], place[c] - place[a]);
    vec3 other = cross(place[across] - place[a], place[b] - place[a]);
#ifdef LINES
    int triangle = element() / 3;
#else
    int triangle = element();
#endif
    if ((triangle_at(triangle).w & 1) == 1) {
        vec3 out_of = normal(number[a]) + normal(number[b]) + normal(number[c]);
        float rise = dot(place[across] - place[a], own);
        if (dot(out_of, own) < 0.0 ? rise < 0.0 : rise > 0.0) return HOLLOW;
    }
    float lengths = length(own) * length(other);
    return dot(own, other) < -SHARP * lengths ? RING : CONTOUR;
}

void emit(int a, int b, int c, int across, int shape, bool shared) {
    vec3 eye_a = (modelview * vec4(place[a], 1.0)).xyz;
    vec3 eye_b = (modelview * vec4(place[b], 1.0)).xyz;
    if (!cut(eye_a, eye_b)) return;
    // Both triangles lie on the left of the edge on the screen. Where both are seen edge on, what
    // is in the object does.
    vec3 within = -1e-3 * distance(place[a], place[b]) * (normal(number[a]) + normal(number[b]));
    vec3 left = clip(place[c]).xyw + clip(place[across]).xyw
              + (projection * (modelview * vec4(within, 0.0))).xyw;
    vec3 at_a = (projection * vec4(eye_a, 1.0)).xyw, at_b = (projection * vec4(eye_b, 1.0)).xyw;
    if (dot(cross(at_a, at_b), left) < 0.0) {
        vec3 kept = eye_a;
        eye_a = eye_b;
        eye_b = kept;
    }
    vec3 from = window(eye_a), to = window(eye_b);
    float size = distance(from.xy, to.xy);
    if (size < 1e-3) return;
    vec2 v = (to.xy - from.xy) / size, n = vec2(v.y, -v.x);
    float deep = pixel_depth(eye_a, normalize(eye_b - eye_a));
    float slack = slack_of(shape, deep, abs(to.z - from.z) / size);
    int marked = shape + (shared && shape == RING ? SHARED : 0);
    line_a = from;
    line_b = to;
    extent = vec3(-half_width, half_width, float(marked));
    grain = vec2(deep, slack + hair + blur * deep);
    slopes = vec4(0.0);
    take_stroke();
#ifdef SHORT_FINS
    if (size > SHORT || !seen(0.5 * size)) return;
#else
    if (apart == 1 && size <= SHORT) return;
#endif
    float side = half_width, beyond_end = joints == ROUND_JOINTS ? side : overhang * size;
    for (int i = 0; i < 4; ++i) {
#ifdef SHORT_FINS
        edge = size;
#else
        line_a = from;
        line_b = to;
        onwards = repeats = vec2(0.0);
        slopes = vec4(0.0);
        extent = vec3(-half_width, half_width, float(marked));
        grain = vec2(deep, slack + hair + blur * deep);
#endif
        float t = i < 2 ? -beyond_end : size + beyond_end, s = (i & 1) == 0 ? -side : side;
        float z = mix(from.z, to.z, clamp(t / size, 0.0, 1.0));
        reach = vec3(t, s, z);
        gl_Position = on_screen(from.xy + t * v + s * n);
        gl_Position.z = 2.0 * (z - range.x) / (range.y - range.x) - 1.0;
        EmitVertex();
    }
    EndPrimitive();
}

// In the article the front triangle draws the edge; here the one whose corner off it has the lesser
// number. At a twisted edge (a Moebius strip) both are front faces, or neither is.
bool draws(int a, int b, int c, int across, int side) {
    if (is_inside(side)) return false;
    if (number[across] == number[a]) return (kinds & OPEN) != 0;
    if ((kinds & CONTOURS) == 0) return false;
    return number[c] <= number[across] && is_front(a, b, c) != is_front(a, across, b);
}

void draw(int a, int b, int c, int across, int side) {
    if (number[across] == number[a]) emit(a, b, c, a, OPEN_SIDE, false);
    else emit(a, b, c, across, kind_of(a, b, c, across), is_shared(side));
}

void main() {
#ifdef LINES
    if (draws(1, 2, 0, 3, 0)) draw(1, 2, 0, 3, 0);
#else
    int drawn = 0;  // bits of its sides
    for (int k = 0; k < 3; ++k)
        if (draws(2 * k, (2 * k + 2) % 6, (2 * k + 4) % 6, 2 * k + 1, k)) drawn |= 1 << k;
    // A side at a time, whichever it is: drivers in software run several triangles in step.
    while (drawn != 0) {
        int a = (drawn & 1) != 0 ? 0 : (drawn & 2) != 0 ? 2 : 4;
        drawn &= drawn - 1;
        draw(a, (a + 2) % 6, (a + 4) % 6, a + 1, a / 2);
    }
#endif
}
