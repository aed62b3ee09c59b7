// What:   a vertex of a triangle or of one beside it.
// Inputs: mesh.glsl.
// Source: Rideout 2010, "Computing Adjacency".

out vec3 place;  // object space
flat out int number;

void main() {
    number = gl_VertexID;
    place = position(number);
    gl_Position = vec4(0.0);
}
