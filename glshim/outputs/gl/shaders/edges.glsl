// Prelude of mesh shaders: an edge of the edge mesh, and what equation 1 says of it.
// Inputs: mesh.glsl.
// Source: McGuire & Hughes 2004, equation 1; numpy reference:
//         glshim/geometry/meshshaders/edge_mesh.py.

struct Edge {
    int v0, v1;            // vertices
    vec3 p0, p1, p2, p3;   // object space
    vec3 out_a, out_b;     // area vectors of its triangles A and B
    bool whole;            // it has two triangles
    bool boundary, marked;
    bool inner;            // inside a polygon that is not flat: no crease
    bool open;             // its component is not closed
    float r;               // the edge's own random number
};

Edge this_edge() {
    Edge e;
    ivec4 v = edge_at(element());
    e.open = v.x < 0;
    e.inner = v.z < 0;
    v = ivec4(v.x < 0 ? ~v.x : v.x, v.y, v.z < 0 ? ~v.z : v.z, v.w);
    e.v0 = v.x;
    e.v1 = v.y;
    e.p0 = position(v.x);
    e.p1 = position(v.y);
    e.p2 = position(v.z);
    e.p3 = position(v.w);
    e.out_a = cross(e.p1 - e.p0, e.p2 - e.p0);
    e.out_b = cross(e.p3 - e.p0, e.p1 - e.p0);
    e.boundary = v.w == v.x;
    e.marked = v.w == v.y;
    e.whole = !e.boundary && !e.marked;
    e.r = random_of(element());
    return e;
}

// Whether triangles A and B have the source (the eye or a light) before them.
bool before_a(Edge e, vec4 source) { return dot(e.out_a, towards(source, e.p0)) > 0.0; }
bool before_b(Edge e, vec4 source) { return dot(e.out_b, towards(source, e.p0)) > 0.0; }

bool is_contour(Edge e, vec4 source) {
    return e.whole && before_a(e, source) != before_b(e, source);
}

const int CONTOUR_EDGE = 1, RIDGE_EDGE = 2, VALLEY_EDGE = 4, MARKED_EDGE = 8, BOUNDARY_EDGE = 16;

// The bits of equation 1; turns are the cosines of the threshold angles of ridges and valleys.
int features(Edge e, vec2 turns) {
    if (e.boundary) return BOUNDARY_EDGE;
    if (e.marked) return MARKED_EDGE;
    bool front = before_a(e, eye);
    int bits = front != before_b(e, eye) ? CONTOUR_EDGE : 0;
    if (e.inner) return bits;
    float product = dot(normalize(e.out_a), normalize(e.out_b));
    float lift = dot(e.p3 - e.p2, e.out_a);
    lift *= e.open ? (front ? 1.0 : -1.0) : facing;
    if (lift <= 0.0 && product < -turns.x) bits |= RIDGE_EDGE;
    if (lift > 0.0 && product < -turns.y) bits |= VALLEY_EDGE;
    return bits;
}
