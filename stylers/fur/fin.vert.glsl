// What:   a fin: the quad between an edge and its end extruded along the normals n0 and n1, near
//         contours, where shells are seen from the side. Two quads, so that it bends.
// Inputs: an edge (edges.glsl); hair.glsl.
// Source: McGuire & Hughes 2004, section 1; Lengyel et al. 2001, section 3.3.

const float NEAR = 0.4;   // |n.v| under which a fin is seen
const int QUADS = 2;

void main() {
    Edge e = this_edge();
    float off0 = abs(dot(normal(e.v0), normalize(towards(eye, e.p0))));
    float off1 = abs(dot(normal(e.v1), normalize(towards(eye, e.p1))));
    bool contour = is_contour(e, eye);
    int quad = corner() / 4, at = corner() - 4 * quad;
    bool first = at == 0 || at == 3;
    int own = first ? e.v0 : e.v1;
    vec3 place = first ? e.p0 : e.p1;
    gl_Position = NOWHERE;
    // A loop, since drivers in software leave loops early but walk through every branch.
    for (int k = 0; k < (contour || min(off0, off1) < NEAR ? 1 : 0); ++k) {
        grow(own, place, out_of(own, place),
             (float(quad) + (at < 2 ? 0.0 : 1.0)) / float(QUADS));
        fade = contour ? 1.0 : 1.0 - smoothstep(0.5 * NEAR, NEAR, first ? off0 : off1);
    }
}
