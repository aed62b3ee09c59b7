// What:   the edge as a line of one pixel, where equation 1 calls it a feature that is asked for.
// Inputs: an edge (edges.glsl); which features; cosines of the threshold angles.
// Source: McGuire & Hughes 2004, section 3.2.

uniform int wanted;     // bits of features
uniform vec2 turns;
uniform vec3 inks[5];   // of contours, ridges, valleys, marked and boundary edges

flat out vec3 ink_here;

void main() {
    Edge e = this_edge();
    int found = features(e, turns) & wanted;
    gl_Position = NOWHERE;
    if (found == 0) return;
    for (int kind = 4; kind >= 0; --kind) if ((found >> kind & 1) == 1) ink_here = inks[kind];
    gl_Position = clip(corner() == 0 ? e.p0 : e.p1);
    gl_Position.z -= 2.0 * hair * gl_Position.w;
}
