// What:   one line of a record as a stroke in the window. For vertex stages.
// Inputs: a line record and the camera (line.glsl); widths in pixels; the threshold angles.
// Source: Raskar 2001, sections 2.1 to 2.4, done on the screen so that the width is exact
//         (derivation and numpy reference: glshim/geometry/raskar.py).

uniform float widths[GROUPS];  // pixels
uniform vec2 valley_turn;      // cosine and sine of the threshold angle

const float INWARD = 0.5;     // pixels by which the middle of a ring's inner rim lies inside
const float EDGE_ON = 0.02;   // quads flatter to the line of sight cannot be seen
const float LONGEST = 8.0;    // pixels of a line that is asked everywhere whether it is seen
const float STEEPEST = 600.0; // pixels' worth of depth a pixel at which slopes are cut

// Normal of the plane that a line lies in. Eye space, all unit; sight is the direction from the
// side to the viewer.
vec3 line_plane(int kind, vec3 along, vec3 normal, vec3 sight) {
    vec3 outward = normalize(cross(along, normal));
    vec3 upright = cross(outward, along);
    if (kind != LONE_RIDGE && kind != LONE_VALLEY) return upright;
    vec2 turn = kind == LONE_RIDGE ? ridge_turn : valley_turn;
    upright *= dot(upright, sight) < 0.0 ? -1.0 : 1.0;
    return turn.y * outward - turn.x * upright;
}

vec2 bounded(vec2 slope, float most) {
    return slope * min(1.0, most / max(length(slope), 1e-30));
}

// False when a short line is seen at none of its pixels: most lines behind others go here.
bool seen_somewhere() {
    if (span > LONGEST) return true;
    for (float t = 0.5 * min(span, 1.0); t < span + 1.0; t += 1.0)
        if (seen_at(min(t, span))) return true;
    return false;
}

// Fills the stroke's varyings, all but the extent of its ink; `deep` is the depth of a pixel at 45
// degrees. False where there is nothing to draw.
bool traced(out float deep, out bool lone) {
    deep = 0.0;
    lone = false;
    line_a = line_b = vec3(0.0);
    onwards = grain = vec2(0.0);
    slopes = vec4(0.0);
    extent = vec3(0.0);
    repeats = edge_kind.yz;
    vec3 eye_a = edge_a, eye_b = edge_b;
    if (!cut(eye_a, eye_b)) return false;
    line_a = window(eye_a);
    line_b = window(eye_b);
    if (distance(line_a.xy, line_b.xy) < 1e-3) return false;
    extent.z = edge_kind.x;
    take_stroke();

    bool outline = kind <= FIN;
    lone = kind == LONE_RIDGE || kind == LONE_VALLEY;
    vec3 sight = normalize(viewpoint.xyz - viewpoint.w * eye_a);
    vec3 side = normalize(eye_b - eye_a);
    vec3 plane = line_plane(kind, side, edge_own, sight);
    float turned = dot(plane, sight);
    if (lone && abs(turned) < EDGE_ON) return false;
    // Behind its polygon; what rises more, too.
    if (kind == LONE_RIDGE && turned < 0.0 && ridge_turn.y >= 0.0) return false;
    if (kind == LONE_VALLEY && turned < 0.0 && valley_turn.y <= 0.0) return false;

    deep = pixel_depth(eye_a, side);
    slopes.xy = bounded(depth_slope(plane, eye_a), STEEPEST * deep);
    slopes.zw = slopes.xy;
    if (edge_other != vec3(0.0))
        slopes.zw = bounded(depth_slope(edge_other, eye_a), STEEPEST * deep);

    if (outline && eye_b == edge_b) {
        vec3 eye_c = edge_c, from_b = edge_b;
        cut(eye_c, from_b);
        vec2 next = window(eye_c).xy - line_b.xy;
        if (dot(next, next) >= 1e-6) {
            next = normalize(next);
            float turn = along.x * next.y - along.y * next.x;
            if (turn > 0.0 || (turn > -1e-3 && dot(along, next) < 0.0)) onwards = next;
        }
    }
    return true;
}

// The depth by which the line may lie behind what is drawn and count as seen: after `traced`.
void take_grain(float deep, bool lone) {
    float slack = slack_of(kind, deep, abs(line_b.z - line_a.z) / span);
    grain = vec2(deep, slack + hair + blur * (lone ? length(slopes.xy) : deep));
}
