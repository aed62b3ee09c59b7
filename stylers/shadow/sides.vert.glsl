// What:   the sides of shadow volumes: edges at which the lit triangles end, driven to infinity.
// Inputs: all edges (mesh.glsl), two quads each; the light.
// Source: McGuire & Hughes 2004, section 7 and figure 1c.
//
// In a closed component the triangles before the light cast the shadow, so that each contour edge
// has one quad. In an open one each triangle casts, turned towards the light: a contour edge has
// two quads, an edge with one triangle has one.

void main() {
    gl_Position = NOWHERE;
    ivec4 v = edge_at(element());
    bool open = v.x < 0;
    int copy = corner() / 4;
    if (copy == 1 && !open) return;
    v = ivec4(open ? ~v.x : v.x, v.y, v.z < 0 ? ~v.z : v.z, v.w);
    bool whole = v.w != v.x;
    vec3 p0 = position(v.x), p1 = position(v.y), p2 = position(v.z);
    bool a = faces(p0, p1, p2, light), b = false;
    if (whole) b = faces(position(v.w), p1, p0, light);
    // How often the border of the casting triangles goes from v0 to v1.
    if (whole ? a == b : copy == 1) return;
    int k = corner() % 4;
    bool turn = a == mirrored;
    bool far = k > 1;
    bool first = (k == 0 || k == 3) == turn;
    vec3 place = first ? p0 : p1;
    gl_Position = far ? driven(place) : clip(place);
}
