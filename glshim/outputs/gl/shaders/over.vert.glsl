// What:   one triangle over the whole canvas.
// Inputs: its corners in clip space.
void main() {
    gl_Position = gl_Vertex;
}
