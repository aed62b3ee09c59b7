// What:   flat ink, rounded at corners.
// Inputs: reach from raskar.vert.glsl; ink.

noperspective in vec2 reach;
uniform vec3 ink;
out vec4 colour;

void main() {
    if (dot(reach, reach) > 1.0001) discard;
    colour = vec4(ink, 1.0);
}
