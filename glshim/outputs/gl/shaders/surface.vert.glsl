#version 120
// The app's polygon exactly where the fixed function puts it.
// Inputs: gl_Vertex and the fixed-function matrices.
void main() {
    gl_Position = ftransform();
    gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;
}
