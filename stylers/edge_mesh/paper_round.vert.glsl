// What:   the edge as a quad around it and around half a disk at each end; ours, in place of caps.
// Inputs: paper.glsl; the fragment cuts the disks out (paper.frag.glsl).
// Source: McGuire & Hughes 2004, section 6 foresees half disks in passes of their own; here they
//         are part of the quad, as the distance from the edge tells.

noperspective out vec2 reached;  // pixels along the edge from s0, and away from it
flat out vec2 extent;            // pixels: how long the edge is, and the reach

void main() {
    gl_Position = NOWHERE;
    Stroke s = this_stroke();
    if (s.kind == 5) return;
    int i = corner();
    bool at_finish = i == 1 || i == 2;
    float far = s.reach + 1.0, size = length(s.s1 - s.s0);
    vec2 onwards = size > 0.0 ? (s.s1 - s.s0) / size : vec2(1.0, 0.0);
    vec2 p = vec2(-onwards.y, onwards.x);
    float across = i >= 2 ? far : s.half_quad ? 0.0 : -far;
    float beyond_end = at_finish ? far : -far;
    reached = vec2((at_finish ? size : 0.0) + beyond_end, across);
    extent = vec2(size, s.reach);
    float step_u = (s.u1 - s.u0) / max(size, 1e-3);
    float u = (at_finish ? s.u1 : s.u0) + (size > 1e-3 ? step_u * beyond_end : 0.0);
    float v = s.half_quad ? 1.0 - across / s.reach : 0.5 - 0.5 * across * s.side0 / s.reach;
    if (s.half_quad) across *= s.side0;
    vec2 on = (at_finish ? s.s1 : s.s0) + beyond_end * onwards;
    put(s, on + across * p, on, at_finish, vec2(u, v));
}
