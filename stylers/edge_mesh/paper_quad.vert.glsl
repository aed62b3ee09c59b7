// What:   the edge as a quad (equation 2) or the outer half of one (equation 3).
// Inputs: paper.glsl.
// Source: McGuire & Hughes 2004, sections 3.3 and 4, figure 9.

void main() {
    gl_Position = NOWHERE;
    Stroke s = this_stroke();
    if (s.kind == 5 || s.p == vec2(0.0)) return;
    int i = corner();
    bool at_finish = i == 1 || i == 2, outer = i >= 2;
    vec2 end = at_finish ? s.s1 : s.s0, p = s.p * s.reach;
    float u = at_finish ? s.u1 : s.u0;
    if (s.half_quad) {
        float a = 0.0, b = length(s.s1 - s.s0), c = 0.0;
        if (capped == 1 && start_fills(s)) a = s.reach * length(s.m0 - s.p * s.side0);
        if (capped == 1 && finish_fills(s)) c = s.reach * length(s.m1 - s.p * s.side1);
        if (outer) u = mix(s.u0, s.u1, (at_finish ? a + b : a) / max(a + b + c, 1e-30));
        put(s, outer ? end + p * s.side0 : end, end, at_finish, vec2(u, outer ? 0.0 : 1.0));
    } else {
        float way = outer ? 1.0 : -1.0;
        put(s, end + way * p, end, at_finish, vec2(u, way == s.side0 ? 0.0 : 1.0));
    }
}
