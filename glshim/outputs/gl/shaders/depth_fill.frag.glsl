#version 120
// What:   cuts polygons at the app's clip planes.
// Inputs: eye-space position; planes (eye space; 0, 0, 0, 1 where none).
uniform vec4 planes[6];
varying vec4 eye;
void main() {
    for (int i = 0; i < 6; ++i) if (dot(planes[i], eye) < 0.0) discard;
    gl_FragColor = vec4(1.0);
}
