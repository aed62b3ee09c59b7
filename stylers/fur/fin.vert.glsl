// What:   a fin: the quad between an edge and its end extruded along the normals n0 and n1, near
//         contours, where shells are seen from the side. Three quads, so that it bends.
// Inputs: an edge (edges.glsl); hair.glsl.
// Source: McGuire & Hughes 2004, section 1; Lengyel et al. 2001, section 3.3.

const float NEAR = 0.4;   // |n.v| under which a fin is seen
const int QUADS = 3;

void main() {
    gl_Position = NOWHERE;
    Edge e = this_edge();
    vec3 n0 = out_of(e.v0, e.p0), n1 = out_of(e.v1, e.p1);
    float off0 = abs(dot(n0, normalize(towards(eye, e.p0))));
    float off1 = abs(dot(n1, normalize(towards(eye, e.p1))));
    bool contour = is_contour(e, eye);
    if (!contour && off0 > NEAR && off1 > NEAR) return;
    int quad = corner() / 4, at = corner() - 4 * quad;
    bool first = at == 0 || at == 3;
    float t = (float(quad) + (at < 2 ? 0.0 : 1.0)) / float(QUADS);
    if (first) grow(e.v0, e.p0, n0, t); else grow(e.v1, e.p1, n1, t);
    fade = contour ? 1.0 : 1.0 - smoothstep(0.5 * NEAR, NEAR, first ? off0 : off1);
}
