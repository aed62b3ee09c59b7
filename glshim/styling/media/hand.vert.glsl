// What:   one line of a stroke, as a hand draws it, and a quad that holds it.
// Inputs: the stroke (trace.glsl), the hand (hand.glsl).
//         Four vertices: a left, a right, b left, b right. Nowhere if nothing is seen.
// Source: NPRQuake's lines; visibility as in Raskar 2001, of the line itself: what the hand strays
//         is not tested, as NPRQuake draws with the depth test off.

// Of a short line, whether most of it is seen: its pixels need not ask.
bool mostly_seen() {
    float balance = 0.0;
    for (float t = 0.5 * min(span, 1.0); t < span + 0.5; t += 1.0)
        balance += seen_at(min(t, span)) ? 1.0 : -1.0;
    return balance > 0.0;
}

void main() {
    gl_Position = NOWHERE;
    hand = vec4(0.0);
    float deep;
    bool lone;
    if (!traced(deep, lone)) return;
    take_grain(deep, lone);
    float width = widths[group];
    extent = vec3(-0.5 * width, 0.5 * width, edge_kind.x);
    hand.xy = edge_hand.xy;
    if (span <= LONGEST) {
        if (!mostly_seen()) return;
        hand.w = 1.0;
    }
    hand.z = min(overshoot, overshoot_share * stroke_length()) * (0.5 + chance(17.0 + way()));

    float reach = 0.75 * width + 1.6 * wobble * share_of_motion() + 1.0;
    bool far = gl_VertexID > 1;
    float past = reach + ((far ? hand.y : hand.x) < AT_END ? hand.z : 0.0);
    vec2 place = far ? line_b.xy + past * along : line_a.xy - past * along;
    gl_Position = on_screen(place + ((gl_VertexID & 1) == 0 ? -reach : reach) * out_1);
}
