// What:   the triangles as the app drew them, for the G-buffer.
// Inputs: mesh.glsl.
// Source: Rideout 2010, "The Spine Test" (the early pass).

out vec3 spot;     // eye space
out vec3 upright;  // eye space, not of unit length
out float sent;    // 1: as the app sent it, -1: turned round, 0: it sent none

void main() {
    mat3 m = mat3(modelview);
    vec4 at = modelview * vec4(position(gl_VertexID), 1.0);
    spot = at.xyz;
    vec4 given = sent_normal(gl_VertexID);
    mat3 way = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    upright = way * given.xyz;
    sent = dot(m[0], way[0]) < 0.0 ? -given.w : given.w;  // GL's own turn with a mirror
    gl_Position = projection * at;
}
