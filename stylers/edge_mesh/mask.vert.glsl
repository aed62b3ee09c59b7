// What:   the model as it is.
// Inputs: its triangles.
// Source: McGuire & Hughes 2004, section 3.4, step 3.
void main() {
    gl_Position = clip(position(triangle_at(element())[corner()]));
}
