// What:   quads along lines on the screen, cut at their ends along the bisectors that they share
//         with the lines before and after. Of both geometry shaders of the style.
// Inputs: triangles with adjacency, corners 0, 2, 4; across the side that begins at a corner the
//         next one, or that corner again where nothing is. stroke.glsl.
// Source: Hajagos et al. 2012, sections 4.2 and 4.3, done on the screen so that the width is exact;
//         numpy reference: glshim/geometry/references/crease_quads.py.

layout(triangles_adjacency) in;

in vec3 place[];
in vec3 turn[];
in vec4 difference[];

uniform float half_width;      // pixels
uniform int cuts;              // 1: ends are cut along bisectors, for textures; 0: they are round

uniform int apart;             // 1: short lines have a shader of their own (SHORT_LINES)

noperspective out vec3 spot;   // pixels along and away from the line (out is positive), own depth
#ifdef SHORT_LINES
flat out vec3 edge;            // its length, depth of a pixel, 1 where it lies on its triangle
#else
flat out int on_surface;       // whether the quad lies on its triangle
#endif

const float SHORT = 4.0;       // pixels: `seen` asks no further, so one answer holds for all of it

const float EDGE_ON = 1e-5;    // cosine between normal and line of sight
const float STEEP = 2.0;       // pixels' worth of depth a pixel by which a quad recedes at most
const float JOINT = 0.05;      // pixels by which quads overlap against rounding
const float HAIRPIN = 1e-4;    // 1 + cosine of a turn that no bisector serves, on the inner side
const float SHARPEST = 0.125;  // the same on the outer side: bisectors up to four widths long

// Whether a triangle turns its outside to the viewer; one that is seen edge-on does not. Flags:
// those of a triangle of its component.
bool is_front(int flags, int i, int j, int k) {
    vec3 a = place[i], b = place[j], c = place[k];
    bool even = put_in_order(a, b, c) == ((flags & 128) != 0);
    vec3 area = cross(b - a, c - a), sight = towards(eye, a);
    return (even ? 1.0 : -1.0) * dot(area, sight) > EDGE_ON * length(area) * length(sight);
}

vec3 in_eye(vec3 point) { return (modelview * vec4(point, 1.0)).xyz; }

vec2 perpendicular(vec2 v) { return vec2(v.y, -v.x); }

// The direction on the screen of a direction in object space, at a point.
vec2 on_the_screen(vec3 way, vec3 point) {
    vec4 here = clip(point);
    return here.w > 0.0 ? projected(way, here) : vec2(0.0);
}

// A line on the screen and what it is joined to.
struct Line {
    vec3 from, to;      // pixels, depth
    vec2 v, n;          // onwards, and to the right of it: outwards
    float size;
    vec2 mitre_a, mitre_b;  // a pixel outwards along the cuts
    bool joined_a, joined_b;
};

// A line the other way round, with the directions of its neighbours.
void turn_round(inout vec3 eye_a, inout vec3 eye_b, inout vec2 v_before, inout vec2 v_after) {
    vec3 kept = eye_a;
    eye_a = eye_b;
    eye_b = kept;
    vec2 way = v_before;
    v_before = -v_after;
    v_after = -way;
}

// The line between two points; whether it has a length.
bool on_window(vec3 eye_a, vec3 eye_b, out Line l) {
    l.from = window(eye_a);
    l.to = window(eye_b);
    l.size = distance(l.from.xy, l.to.xy);
    if (l.size < 1e-3) return false;
    l.v = (l.to.xy - l.from.xy) / l.size;
    l.n = perpendicular(l.v);
    return true;
}

// The cut between a line and its neighbour, which runs on in a direction; 0: there is none.
vec2 mitre(Line l, vec2 neighbour, bool left_side_only, out bool joined) {
    vec2 other = perpendicular(neighbour);
    float turned = 1.0 + dot(other, l.n);
    joined = cuts == 1 && neighbour != vec2(0.0) && turned > (left_side_only ? HAIRPIN : SHARPEST);
    return joined ? (other + l.n) / turned : l.n;
}

// A quad between two distances outwards from a line, in the plane of the triangle on its left or in
// that of the screen. planes: depths a pixel on the triangles on the left and on the right.
void put(Line l, float low, float high, vec4 planes, int kind, bool flat_on, float deep) {
    float slack = slack_of(kind, deep, abs(l.to.z - l.from.z) / l.size);
    // Of a triangle seen edge-on the quad would reach far behind whatever is drawn beyond it.
    vec2 own = planes.xy + l.n * max(0.0, -STEEP * deep - dot(planes.xy, l.n));
    vec2 lean = vec2(dot(l.mitre_a, l.v), dot(l.mitre_b, l.v));
    float cap = max(-low, high);
    line_a = l.from;
    line_b = l.to;
    slopes = planes;
    extent = vec3(low, high, float(kind));
    grain = vec2(deep, slack + hair + blur * deep);
    take_stroke();
#ifdef SHORT_LINES
    if (l.size > SHORT || !seen(0.5 * l.size)) return;
#else
    if (apart == 1 && l.size <= SHORT) return;
#endif
    float past_a = l.joined_a ? JOINT : cap, past_b = l.joined_b ? JOINT : cap;
    for (int i = 0; i < 4; ++i) {
        float s = (i & 1) == 0 ? low : high;
        // Where the cuts meet the quad ends in a point: beyond, it would be folded.
        float room = l.size + past_a + past_b + s * (lean.y - lean.x);
        if (room < 0.0) s *= 1.0 + room / (l.size + past_a + past_b - room);
        float t = i < 2 ? s * lean.x - past_a : l.size + s * lean.y + past_b;
        vec2 aside = t * l.v + s * l.n;
#ifdef SHORT_LINES
        edge = vec3(l.size, deep, float(flat_on));
#else
        line_a = l.from;
        line_b = l.to;
        onwards = repeats = vec2(0.0);
        slopes = planes;
        extent = vec3(low, high, float(kind));
        grain = vec2(deep, slack + hair + blur * deep);
        on_surface = int(flat_on);
#endif
        spot = vec3(t, s, l.from.z + dot(own, aside));
        gl_Position = on_screen(l.from.xy + aside);
        EmitVertex();
    }
    EndPrimitive();
}
