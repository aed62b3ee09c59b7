// What:   triangles as the app drew them: all, or those seen from the side away from the light.
// Inputs: triangles (mesh.glsl), the light, the eye; which.

uniform bool every;

void main() {
    gl_Position = NOWHERE;
    ivec4 t = triangle_at(element());
    vec3 p[3] = vec3[3](position(t.x), position(t.y), position(t.z));
    bool same = faces(p[0], p[1], p[2], light) == faces(p[0], p[1], p[2], eye);
    if (same && !every) return;
    gl_Position = clip(p[corner()]);
}
