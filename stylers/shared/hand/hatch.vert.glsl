// What:   the triangles as the app drew them, for hatching.
// Inputs: mesh.glsl.

out vec3 spot;     // eye space
out vec3 upright;  // eye space, not of unit length
out vec3 held;     // where hatching is held: object space, as first seen

void main() {
    mat3 m = mat3(modelview);
    vec4 at = modelview * vec4(position(gl_VertexID), 1.0);
    spot = at.xyz;
    held = rest(gl_VertexID).xyz;
    upright = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])) * normal(gl_VertexID);
    gl_Position = projection * at;
}
