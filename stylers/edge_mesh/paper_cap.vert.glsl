// What:   the start cap (equation 4) and the finish cap (equation 5) of an edge, two triangles.
// Inputs: paper.glsl.
// Source: McGuire & Hughes 2004, sections 3.3 and 4, figure 9. The rule j = i or 2 - i makes front
//         faces of the caps that fill a gap; as printed it is the start's, the finish mirrors it.
//         Which faces the app calls front ones is not known here, so back faces are left out here.

void main() {
    gl_Position = NOWHERE;
    Stroke s = this_stroke();
    if (s.kind == 5 || s.p == vec2(0.0)) return;
    bool finish = corner() >= 3;
    if (!(finish ? finish_fills(s) : start_fills(s))) return;
    int i = finish ? corner() - 3 : corner();
    bool forward = finish ? s.side1 < 0.0 : s.side0 > 0.0;
    int j = forward ? i : 2 - i;
    vec2 end = finish ? s.s1 : s.s0;
    vec2 m = finish ? s.m1 : s.m0, p = s.p * (finish ? s.side1 : s.side0);
    float u = finish ? s.u1 : s.u0;
    if (s.half_quad && j == 1) {  // the outer corner of the quad, as that has it
        float a = start_fills(s) ? s.reach * length(s.m0 - s.p * s.side0) : 0.0;
        float b = length(s.s1 - s.s0);
        float c = finish_fills(s) ? s.reach * length(s.m1 - s.p * s.side1) : 0.0;
        u = mix(s.u0, s.u1, (finish ? a + b : a) / max(a + b + c, 1e-30));
    }
    vec2 place = j == 0 ? end : end + s.reach * (j == 1 ? p : m);
    put(s, place, end, finish, vec2(u, j > 0 ? 0.0 : s.half_quad ? 1.0 : 0.5));
}
