// What:   a triangle of a shell: the mesh displaced along its normals, a layer a copy.
// Inputs: hair.glsl; the number of shells.
// Source: Lengyel et al. 2001, section 3.2; McGuire & Hughes 2004, section 1.

uniform int shells;

const float AWAY = -0.35;  // n.v under which hairs do not reach over the contour

void main() {
    ivec4 v = triangle_at(element());
    vec3 p0 = position(v.x), p1 = position(v.y), p2 = position(v.z);
    int own = corner() == 0 ? v.x : corner() == 1 ? v.y : v.z;
    vec3 place = corner() == 0 ? p0 : corner() == 1 ? p1 : p2;
    vec3 area = cross(p1 - p0, p2 - p0), view = towards(eye, p0);
    float turn = rest(own).w * dot(area, view) / max(length(area) * length(view), 1e-37);
    // What faces away is under the shells that face the viewer, or, where the mesh is open, shows
    // its inside, which has fur of its own.
    bool closed = v.w == 1;
    float side = !closed && turn < 0.0 ? -1.0 : 1.0;
    gl_Position = NOWHERE;
    // A loop, since drivers in software leave loops early but walk through every branch.
    for (int k = 0; k < (closed && turn < AWAY ? 0 : 1); ++k) {
        grow(own, place, side * out_of(own, place), (float(gl_InstanceID) + 0.15) / float(shells));
        if (gl_InstanceID == 0) gl_Position.z -= 2.0 * hair * gl_Position.w * away;
    }
}
