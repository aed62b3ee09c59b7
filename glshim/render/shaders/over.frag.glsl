#version 330
// Ink where there is some, pixel for pixel.
// Inputs: ink, as large as the viewport.
uniform sampler2D ink;
out vec4 colour;
void main() {
    colour = texelFetch(ink, ivec2(gl_FragCoord.xy), 0);
    if (colour.a == 0.0) discard;
}
