// What:   the edge as a line of one pixel, where equation 1 calls it a feature that is asked for.
// Inputs: paper.glsl.
// Source: McGuire & Hughes 2004, section 3.2.

void main() {
    gl_Position = NOWHERE;
    Stroke s = this_stroke();
    if (s.kind == 5) return;
    if (corner() == 0) put(s, s.s0, s.s0, false, vec2(s.u0, 0.5));
    else put(s, s.s1, s.s1, true, vec2(s.u1, 0.5));
}
