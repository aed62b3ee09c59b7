// What:   the halves of creases, each in the plane of its triangle; and where a crease is a
//         contour, or has one triangle only, the half beyond it, in the plane of the screen.
// Inputs: quads.glsl; which sides are creases (mesh.glsl), or the verifiers.
// Source: Hajagos et al. 2012, sections 4 and 4.2. The half beyond contours is ours: section 6
//         leaves creases on contours half as wide.

layout(triangle_strip, max_vertices = 24) out;

uniform int kinds;        // bits of those that are drawn: ridges, valleys, open sides, contours
uniform int parted;       // 1: creases that are contours are contours; 0: ridges and valleys
uniform int verified;     // 1: the verifiers decide, as in the paper; 0: the exact flags

const int OUT = 1, IN = 2, OPEN = 4, OUTER = 8;
const float UNIT = 1e-3;  // by how much a length may differ from 1
const float SINE = 1e-3;  // by how much a verifier may be missed
const float STEEPEST = 600.0;  // pixels' worth of depth a pixel at which slopes are cut

// Whether the side is a crease for all that its ends say. ways: from the side's direction e to the
// directions of the creases before and after it.
bool says_crease(vec4 at_a, vec4 at_b, vec3 e) {
    if (at_a.w > 1.5 || at_b.w > 1.5) return false;
    vec3 e_before = e - at_a.xyz, e_after = e + at_b.xyz;
    return abs(length(e_before) - 1.0) < UNIT && abs(length(e_after) - 1.0) < UNIT
        && abs(e_before.y * e.z - e_before.z * e.y - at_a.w) < SINE
        && abs(e.y * e_after.z - e.z * e_after.y - at_b.w) < SINE;
}

// Depth a pixel on the plane through a line and a corner.
vec2 slope_of(vec3 eye_a, vec3 eye_b, vec3 point, float deep) {
    vec3 area = cross(eye_b - eye_a, in_eye(point) - eye_a);
    vec2 slope = depth_slope(area / max(length(area), 1e-30), eye_a);
    return slope * min(1.0, STEEPEST * deep / max(length(slope), 1e-30));
}

// The side from corner a to corner b, c being the third, and d that of the next triangle.
void emit(int a, int b, int c, int d, bool contour, int kind) {
    vec3 e = normalize(place[b] - place[a]);
    vec3 e_before = e - difference[a].xyz, e_after = e + difference[b].xyz;
    vec3 eye_a = in_eye(place[a]), eye_b = in_eye(place[b]), whole_a = eye_a, whole_b = eye_b;
    if (!cut(eye_a, eye_b)) return;
    vec2 v_before = eye_a == whole_a ? on_the_screen(e_before, place[a]) : vec2(0.0);
    vec2 v_after = eye_b == whole_b ? on_the_screen(e_after, place[b]) : vec2(0.0);
    // The triangle lies on the left of the line.
    vec3 at_a = (projection * vec4(eye_a, 1.0)).xyw, at_b = (projection * vec4(eye_b, 1.0)).xyw;
    if (dot(cross(at_a, at_b), clip(place[c]).xyw) < 0.0)
        turn_round(eye_a, eye_b, v_before, v_after);
    Line l;
    if (!on_window(eye_a, eye_b, l)) return;
    float deep = pixel_depth(eye_a, normalize(eye_b - eye_a));
    vec4 planes = vec4(slope_of(eye_a, eye_b, place[c], deep), vec2(0.0));
    planes.zw = place[d] == place[a] ? planes.xy : slope_of(eye_a, eye_b, place[d], deep);
    // The outer side of a bend is where a bisector grows long.
    l.mitre_a = mitre(l, v_before, dot(l.n, v_before) > 0.0, l.joined_a);
    l.mitre_b = mitre(l, v_after, dot(l.n, v_after) < 0.0, l.joined_b);
    put(l, -half_width - 1.0, JOINT, planes, kind, true, deep);
    if (!contour) return;
    l.mitre_a = l.mitre_b = l.n;
    l.joined_a = l.joined_b = false;
    put(l, -JOINT, half_width + 1.0, planes, kind, false, deep);
}

// Whether a fold of the triangle a, b, c, d being the next one's corner, stands out to the viewer.
bool is_ridge(int a, int b, int c, int d) {
    vec3 area = cross(place[b] - place[a], place[c] - place[a]);
    float rise = dot(area, place[d] - place[a]);
    return dot(area, towards(eye, place[a])) > 0.0 ? rise <= 0.0 : rise >= 0.0;
}

void main() {
    int flags = triangle_at(element()).w;
    bool closed = (flags & 1) == 1, front = is_front(flags, 0, 2, 4);
    if (closed && !front) return;
    for (int k = 0; k < 3; ++k) {
        int a = 2 * k, across = a + 1, b = (a + 2) % 6, c = (a + 4) % 6;
        bool crease = (flags >> (k + 1) & 1) == 1, open = (flags >> (k + 4) & 1) == 1;
        if (verified == 1)
            crease = says_crease(difference[a], difference[b], normalize(place[b] - place[a]));
        if (!crease || is_inside(k)) continue;
        bool contour = open || (front && !is_front(flags, a, across, b));
        int own = open ? OPEN : contour && parted == 1 ? OUTER
                : is_ridge(a, b, c, across) ? OUT : IN;
        if ((kinds & own) == 0) continue;
        int kind = open ? RING + 16 * (BOUNDARY - 3) : contour ? RING : RIDGE;
        emit(a, b, c, across, contour, kind + (is_shared(k) ? SHARED : 0));
    }
}
