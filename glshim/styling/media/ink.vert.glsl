// What:   the stroke of one line in the window, and a quad that holds it.
// Inputs: the stroke (trace.glsl).
//         Four vertices: a inside, a outside, b inside, b outside. Nowhere if nothing is seen.
// Source: Raskar 2001, sections 2.1 to 2.4.

void main() {
    gl_Position = NOWHERE;
    float deep;
    bool lone;
    if (!traced(deep, lone)) return;
    bool outline = kind <= FIN;
    float width = widths[group];
    float inward = outline ? INWARD : 0.5 * width;
    extent = vec3(-inward, width - inward, edge_kind.x);
    take_grain(deep, lone);

    if (hidden_share == 0.0 && !seen_somewhere()) return;

    // The quad: a pixel beyond the ink, round at the ends of what is not an outline.
    bool corner = onwards != vec2(0.0), far = gl_VertexID > 1;
    float reach = extent.y + 1.0;
    float past = outline ? (far && corner ? reach : 1.0) : reach;
    float inner = corner && dot(along, onwards) < 0.0 ? -reach : extent.x - 1.0;
    vec2 place = far ? line_b.xy + past * along : line_a.xy - past * along;
    gl_Position = on_screen(place + ((gl_VertexID & 1) == 0 ? inner : reach) * out_1);
}
