#version 120
// One flat colour.
// Inputs: colour, linear 0..1, opaque.
uniform vec4 colour;
void main() { gl_FragColor = colour; }
