#version 120
// What:   paint without the app's textures.
// Inputs: the paint of paint.vert.glsl.
void main() { gl_FragColor = gl_Color; }
