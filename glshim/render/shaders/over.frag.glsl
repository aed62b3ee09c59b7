#version 120
// What:   the gathered ink, pixel for pixel.
// Inputs: ink (premultiplied), as large as the viewport.
uniform sampler2D ink;
varying vec2 place;
void main() {
    gl_FragColor = texture2D(ink, place);
    if (gl_FragColor.a == 0.0) discard;
}
