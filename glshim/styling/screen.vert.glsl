// What:   one triangle over the viewport.
void main() {
    gl_Position = vec4(float(corner() & 1) * 4.0 - 1.0, float(corner() & 2) * 2.0 - 1.0, 0.0, 1.0);
}
