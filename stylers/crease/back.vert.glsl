// What:   the surfaces, with n.c for the fragments.
// Inputs: mesh.glsl.
// Source: Hajagos et al. 2012, section 5.

out float facing_us;

void main() {
    vec3 point = position(gl_VertexID);
    facing_us = dot(normal(gl_VertexID), towards(eye, point));
    gl_Position = clip(point);
}
