#version 120
// What:   one triangle over the whole canvas.
// Inputs: its corners in clip space.
varying vec2 place;
void main() {
    place = 0.5 * gl_Vertex.xy + 0.5;
    gl_Position = gl_Vertex;
}
