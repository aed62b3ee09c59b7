#version 130
// What:   one triangle over everything.
// Inputs: its corners in clip space.
void main() {
    gl_Position = gl_Vertex;
}
