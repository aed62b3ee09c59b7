// What:   a topology vertex of a triangle or of one beside it.
// Inputs: mesh.glsl.
// Source: Hajagos et al. 2012, section 3.

out vec3 place;       // object space
out vec3 turn;        // unit normal
out vec4 difference;  // crease difference and verifier

void main() {
    place = position(gl_VertexID);
    turn = normal(gl_VertexID);
    difference = texelFetch(mesh_creases, texel(gl_VertexID), 0);
    gl_Position = vec4(0.0);
}
