// What:   the contour of the smooth surface in a triangle: where the interpolated n.c is zero.
// Inputs: quads.glsl; which sides are creases (mesh.glsl), over which normals jump.
// Source: Hajagos et al. 2012, section 4.3 (A. Hertzmann 1999). Ends fit the contours next to it.

layout(triangle_strip, max_vertices = 12) out;

uniform int back_faces;  // 1: they alone hide contours
uniform int creased;     // 1: creases are drawn, too

// As glshim/linework/smooth_lines.py has them.
const float BENT = 0.02;    // a vertex normal so far from the triangle's bends it wholly
const float NEAREST = 0.2;  // share of the way to the viewer that a line is lifted at most

float toward[6];  // n.c of each vertex

// Where n.c is zero between two corners; the same to the bit, whoever asks.
vec3 crossing(int a, int b) {
    if (comes_before(place[b], place[a])) { int i = a; a = b; b = i; }
    return (toward[a] * place[b] - toward[b] * place[a]) / (toward[a] - toward[b]);
}

// The normal there, not of unit length.
vec3 normal_at(int a, int b) {
    return (toward[a] * turn[b] - toward[b] * turn[a]) / (toward[a] - toward[b]);
}

// By how much a vertex normal differs from a triangle's, as an angle; at a tip there is none.
float bend(int v, vec3 plane) {
    return turn[v] == vec3(0.0) ? BENT : distance(turn[v], plane);
}

// How far the smooth surface leaves a side, and some more: by how much its normals turn along it.
float swell(int a, int b) {
    if (turn[a] == vec3(0.0) || turn[b] == vec3(0.0)) return 0.0;
    return abs(dot(turn[b] - turn[a], place[b] - place[a]));
}

// How far, in object units, the smooth surface may lie before a triangle: its width, less where it
// is hardly bent; of slivers, around poles, by how much it leaves their sides.
float lift(int a, int b, int c) {
    vec3 area = cross(place[b] - place[a], place[c] - place[a]);
    float size = length(area);
    if (size <= 0.0) return 0.0;
    float longest = max(max(distance(place[a], place[b]), distance(place[b], place[c])),
                        distance(place[c], place[a]));
    vec3 plane = area / size * (dot(area, turn[a] + turn[b] + turn[c]) < 0.0 ? -1.0 : 1.0);
    float bent = max(max(bend(a, plane), bend(b, plane)), bend(c, plane));
    return max(min(bent / BENT, 1.0) * size / longest,
               max(max(swell(a, b), swell(b, c)), swell(c, a)));
}

// A point in eye space, moved towards the viewer.
vec3 lifted(vec3 point, float by) {
    vec3 at = in_eye(point), sight = viewpoint.xyz - viewpoint.w * at;
    float distance = length(sight);
    return at + sight / distance * (viewpoint.w == 0.0 ? by : min(by, NEAREST * distance));
}

bool crease_between(int flags, int a) { return (flags >> (a / 2 + 1) & 1) == 1; }

// The other end of the contour that runs on over the side between corners a and b; none: false.
bool goes_on(int flags, int a, int across, int b, out vec3 other) {
    if (crease_between(flags, a) || place[across] == place[a]) return false;
    int end = (toward[across] > 0.0) != (toward[a] > 0.0) ? a : b;
    other = crossing(across, end);
    return true;
}

// The direction on the screen from one point to another; 0 where that is not before the viewer.
vec2 way(vec3 from, vec3 to) {
    vec4 a = clip(from), b = clip(to);
    if (a.w <= 0.0 || b.w <= 0.0) return vec2(0.0);
    vec2 found = pixels(b) - pixels(a);
    return length(found) < 1e-3 ? vec2(0.0) : normalize(found);
}

// The quad from one point to another, where the surface ends in a direction.
void emit(vec3 from, vec3 to, vec2 v_before, vec2 v_after, float by, vec3 outwards) {
    vec3 eye_a = lifted(from, by), eye_b = lifted(to, by), whole_a = eye_a, whole_b = eye_b;
    if (!cut(eye_a, eye_b)) return;
    if (eye_a != whole_a) v_before = vec2(0.0);
    if (eye_b != whole_b) v_after = vec2(0.0);
    vec2 right = perpendicular(window(eye_b).xy - window(eye_a).xy);
    if (dot(right, on_the_screen(outwards, eye_a == whole_a ? from : to)) < 0.0)
        turn_round(eye_a, eye_b, v_before, v_after);
    Line l;
    if (!on_window(eye_a, eye_b, l)) return;
    float deep = pixel_depth(eye_a, normalize(eye_b - eye_a));
    l.mitre_a = mitre(l, v_before, false, l.joined_a);
    l.mitre_b = mitre(l, v_after, false, l.joined_b);
    float far = half_width + 1.0;
    put(l, -far, far, vec4(0.0), CONTOUR, false, deep);
}

void main() {
    for (int i = 0; i < 6; ++i) toward[i] = dot(turn[i], towards(eye, place[i]));
    bvec3 facing_us = bvec3(toward[0] > 0.0, toward[2] > 0.0, toward[4] > 0.0);
    if (all(facing_us) || !any(facing_us)) return;
    // The corner o whose sign is its own; the contour runs from side o, p to side q, o.
    int o = facing_us.y == facing_us.z ? 0 : facing_us.x == facing_us.z ? 2 : 4;
    int p = (o + 2) % 6, q = (o + 4) % 6;
    int flags = triangle_at(element()).w;
    vec3 y0 = crossing(o, p), y1 = crossing(q, o), other;
    vec2 v_before = goes_on(flags, o, o + 1, p, other) ? way(other, y0) : vec2(0.0);
    vec2 v_after = goes_on(flags, q, q + 1, o, other) ? way(y1, other) : vec2(0.0);

    // The polygons lie about the surface that is meant, before it and behind.
    float by = lift(0, 2, 4);
    for (int k = 0; k < 6; k += 2)
        if (!crease_between(flags, k)) by = max(by, lift(k, k + 1, (k + 2) % 6));
    by *= pow(abs(determinant(mat3(modelview))), 1.0 / 3.0);
    // Where n.c grows towards the viewer the surface ends on the side of its normal.
    vec3 u = place[2] - place[0], v = place[4] - place[0], area = cross(u, v);
    vec3 rise = cross(v, area) * (toward[2] - toward[0]) + cross(area, u) * (toward[4] - toward[0]);
    vec3 sight = towards(eye, (place[0] + place[2] + place[4]) / 3.0);
    vec3 outwards = normal_at(o, p) + normal_at(q, o);
    // Where it falls a closed surface lies before its own contour, and no back face before that.
    bool falls = dot(rise, sight) < 0.0;
    if (falls && back_faces == 1 && (flags & 1) == 1) return;
    emit(y0, y1, v_before, v_after, by, falls ? -outwards : outwards);
    if (creased == 0 || dot(area, sight) * dot(area, turn[0] + turn[2] + turn[4]) >= 0.0) return;
    // A contour that runs into a crease behind the polygons' own outline leaves a gap up to that.
    vec2 none = vec2(0.0);
    if (crease_between(flags, o))
        emit(place[toward[o] > 0.0 ? o : p], y0, none, none, by, y0 - place[q]);
    if (crease_between(flags, q))
        emit(y1, place[toward[o] > 0.0 ? o : q], none, none, by, y1 - place[p]);
}
