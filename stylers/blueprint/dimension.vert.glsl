// What:   of a straight edge that is seen whole, now and then, a quad for its dimension.
// Inputs: the line (trace.glsl); how many edges have dimensions.
// Source: NPRQuake's blueprint.

uniform float frequency;  // of edges that have a dimension, 0..1
uniform float least;      // pixels of an edge that has one

const float AT_END = 0.02;
const int MARK = 16;      // GROUP of glshim/model/lines.py

// Depth where the dimension goes: u, v in 0..1 along the line and out from it.
float depth_at(float u, float v) {
    float out_to = mix(4.0 * shot.z, OFF + HIGH + 4.0 * shot.z, v);
    vec2 place = line_a.xy + u * span * along + out_to * out_1;
    return finished(floor(place) + 0.5);
}

// Whether no line can be there: it is all background, or one flat surface.
bool is_free() {
    float corner = depth_at(0.0, 0.0);
    float to_b = depth_at(1.0, 0.0) - corner, out_by = depth_at(0.0, 1.0) - corner;
    bool bare = corner >= max(away, 0.0);
    float most = bare ? 0.0 : 8.0 * hair + 0.02 * (abs(to_b) + abs(out_by));
    for (float u = 0.0; u < 1.01; u += 0.125)
        for (float v = 0.0; v < 1.01; v += 0.25)
            if (abs(depth_at(u, v) - corner - u * to_b - v * out_by) > most) return false;
    return !bare || (to_b == 0.0 && out_by == 0.0);
}

void main() {
    gl_Position = NOWHERE;
    dimension = vec2(0.0);
    float deep;
    bool lone;
    if (edge_hand.x > AT_END || edge_hand.y > AT_END || edge_hand.z == 0.0) return;
    if (edge_hand.z >= frequency || !traced(deep, lone) || span < least) return;
    if (kind != RING && kind != RIDGE && kind != FIN) return;
    take_grain(deep, lone);
    vec3 eye_a = edge_a, eye_b = edge_b;
    if (!cut(eye_a, eye_b) || eye_a != edge_a || eye_b != edge_b) return;
    for (float part = 0.1; part < 0.95; part += 0.16) if (!seen_at(part * span)) return;
    float length = distance(edge_a, edge_b);
    if (length > MOST || length < 1e-3) return;
    float after = decimals(length), before = max(floor(log(length) / log(10.0) + 1e-4) + 1.0, 1.0);
    dimension = vec2(length, before + (after > 0.0 ? after + 1.0 : 0.0));
    if (WIDE * dimension.y + 8.0 > span) return;
    if (!is_free()) return;
    bool far = gl_VertexID > 1;
    vec2 place = far ? line_b.xy + 2.0 * along : line_a.xy - 2.0 * along;
    float out_by = (gl_VertexID & 1) == 0 ? 0.0 : OFF + HIGH + 6.0;
    gl_Position = on_screen(place + out_by * out_1);
}
