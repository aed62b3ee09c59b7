// What:   all of the window, at the far plane.
void main() {
    vec2 place = vec2(corner() == 1 ? 3.0 : -1.0, corner() == 2 ? 3.0 : -1.0);
    gl_Position = vec4(place, deeper(), 1.0);
}
