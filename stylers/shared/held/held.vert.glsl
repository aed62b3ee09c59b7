// What:   the triangles as the app drew them, with where each place of a surface was when its mesh
//         was first seen.
// Inputs: mesh.glsl.

out vec3 held;

void main() {
    // In the lengths of eye space: an app that scales a cube into a floor stretches no pattern.
    mat3 m = mat3(modelview);
    held = rest(gl_VertexID).xyz * vec3(length(m[0]), length(m[1]), length(m[2]));
    gl_Position = projection * (modelview * vec4(position(gl_VertexID), 1.0));
}
