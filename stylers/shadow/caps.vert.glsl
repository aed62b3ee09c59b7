// What:   the ends of shadow volumes: the casting triangles, and the same at infinity.
// Inputs: triangles (mesh.glsl), one of each kind; the light.
// Source: McGuire & Hughes 2004, section 7 and figure 1c.

void main() {
    gl_Position = NOWHERE;
    ivec4 t = triangle_at(element());
    vec3 p[3] = vec3[3](position(t.x), position(t.y), position(t.z));
    bool lit = faces(p[0], p[1], p[2], light);
    if (t.w == 1 && !lit) return;
    bool far = corner() > 2;
    int k = corner() % 3;
    if ((lit == far) != mirrored && k > 0) k = 3 - k;
    gl_Position = far ? driven(p[k]) : clip(p[k]);
}
