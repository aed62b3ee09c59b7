#version 120
// What:   polygons as the app places them, for their depth alone.
// Inputs: vertex in object space; modelview and projection.
attribute vec3 vertex;
uniform mat4 modelview;
uniform mat4 projection;
varying vec4 eye;
void main() {
    eye = modelview * vec4(vertex, 1.0);
    gl_Position = projection * eye;
}
