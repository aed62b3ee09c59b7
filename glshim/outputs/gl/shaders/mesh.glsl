// Prelude of every mesh shader's vertex and geometry stage: the recovered mesh, the camera and the
// light. A vertex has no attributes: it looks its element up by number.
// Inputs: textures of positions and normals (a texel a vertex), edges <v0, v1, v2, v3> and
//         triangles.
// Source: McGuire & Hughes 2004, section 3 (the edge vertex), 3.6 (key frames, bones), by indices
//         as their section 6 foresees. Numpy references: glshim/geometry/meshshaders/edge_mesh.py,
//         poses.py.

uniform sampler2D mesh_positions;   // object space; with creases also the vertex's number, from 1
uniform sampler2D mesh_normals;     // out of the object, where it has an outside; with creases also
                                    // 1: as the app sent it, -1: turned round, 0: it sent none
uniform isampler2D mesh_edges;      // v3 = v0: boundary; v3 = v1: marked; v2 < 0: ~v2, a diagonal
uniform isampler2D mesh_triangles;  // three vertices; 1 where its component is closed; with
                                    // creases also 2, 4, 8: of sides; 16, 32, 64: open sides;
                                    // 128: it winds about what is in
uniform sampler2D mesh_rest;        // positions as first seen; +1: triangles wind about what is
                                    // out, -1: about what is in, 0: an open mesh has no outside
// crease differences and verifiers (glshim/geometry/crease/creases.py)
uniform sampler2D mesh_creases;
uniform int vertices_each;          // vertices an element is drawn with

uniform mat4 modelview;
uniform vec4 eye;        // the viewer in object space, homogeneous: a direction to it where w = 0
uniform vec4 light;      // GL_LIGHT0 in object space, homogeneous
uniform float facing;    // +1 where triangles that wind counter-clockwise about their normal face
                         // the viewer as the app means it, else -1

ivec2 texel(int i) { return ivec2(i & 2047, i >> 11); }
#ifdef GEOMETRY_STAGE
int drawn() { return gl_PrimitiveIDIn; }
#else
int drawn() { return gl_VertexID / vertices_each; }
int corner() { return gl_VertexID - vertices_each * (gl_VertexID / vertices_each); }
#endif
#ifdef SIEVED
uniform isampler2D mesh_sieved;     // numbers of the elements that are drawn, and how they touch
int element() { return texelFetch(mesh_sieved, texel(drawn()), 0).x; }
int touching() { return texelFetch(mesh_sieved, texel(drawn()), 0).y; }
#else
int element() { return drawn(); }
int touching() { return 0; }
#endif
// Of a side of the element: whether it lies on one of another object; whether it is no edge of what
// the objects make together.
bool is_shared(int side) { return (touching() >> side & 1) == 1; }
bool is_inside(int side) { return (touching() >> side + 3 & 1) == 1; }
ivec4 edge_at(int i) { return texelFetch(mesh_edges, texel(i), 0); }
ivec4 triangle_at(int i) { return texelFetch(mesh_triangles, texel(i), 0); }

// A number in 0..1 that belongs to an element and looks random.
float random_of(int i) {
    uint h = uint(i) * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
    return float(((h >> 22u) ^ h) & 0xFFFFu) / 65536.0;
}

#if defined(KEYFRAMES)
uniform sampler2D next_positions;
uniform sampler2D next_normals;
uniform float share;
vec3 position(int v) {
    vec3 from = texelFetch(mesh_positions, texel(v), 0).xyz;
    return from + share * (texelFetch(next_positions, texel(v), 0).xyz - from);
}
vec3 normal(int v) {
    vec3 from = texelFetch(mesh_normals, texel(v), 0).xyz;
    return normalize(from + share * (texelFetch(next_normals, texel(v), 0).xyz - from));
}
#elif defined(BONES)
uniform isampler2D mesh_bones;
uniform sampler2D mesh_weights;
uniform mat4 bones[BONES];
mat4 blended(int v) {
    ivec4 which = texelFetch(mesh_bones, texel(v), 0);
    vec4 weight = texelFetch(mesh_weights, texel(v), 0);
    return weight.x * bones[which.x] + weight.y * bones[which.y] + weight.z * bones[which.z]
         + weight.w * bones[which.w];
}
vec3 position(int v) {
    return (blended(v) * vec4(texelFetch(mesh_positions, texel(v), 0).xyz, 1.0)).xyz;
}
vec3 normal(int v) {
    mat3 m = mat3(blended(v));
    mat3 turn = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    return normalize(turn * texelFetch(mesh_normals, texel(v), 0).xyz);
}
#else
vec3 position(int v) { return texelFetch(mesh_positions, texel(v), 0).xyz; }
vec3 normal(int v) { return texelFetch(mesh_normals, texel(v), 0).xyz; }
vec4 sent_normal(int v) { return texelFetch(mesh_normals, texel(v), 0); }
#endif

// Where a vertex was when its mesh was first seen, and which way is out (mesh_rest): patterns that
// are to stay on a surface that moves are taken from here. Topology vertices know which vertex they
// are a part of.
vec4 rest(int v) {
    int whole = int(texelFetch(mesh_positions, texel(v), 0).w) - 1;
    return texelFetch(mesh_rest, texel(whole < 0 ? v : whole), 0);
}

// Towards an eye or a light, homogeneous, from a point; not of unit length.
vec3 towards(vec4 source, vec3 point) { return source.xyz - source.w * point; }

bool comes_before(vec3 p, vec3 q) {
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

// Puts the corners of a triangle in one order, and says whether that turns it round: whoever asks
// about it then computes the same to the bit. Both triangles at an edge ask for each other, and
// must not disagree about one that is seen edge on.
bool put_in_order(inout vec3 a, inout vec3 b, inout vec3 c) {
    bool odd = false;
    if (comes_before(b, a)) { vec3 t = a; a = b; b = t; odd = !odd; }
    if (comes_before(c, b)) { vec3 t = b; b = c; c = t; odd = !odd; }
    if (comes_before(b, a)) { vec3 t = a; a = b; b = t; odd = !odd; }
    return odd;
}

// Whether a triangle winds counter-clockwise as seen from a source (the eye or a light).
bool faces(vec3 a, vec3 b, vec3 c, vec4 source) {
    bool odd = put_in_order(a, b, c);
    return (dot(cross(b - a, c - a), towards(source, a)) > 0.0) != odd;
}

vec4 clip(vec3 point) { return projection * (modelview * vec4(point, 1.0)); }

// Pixels from the middle of the viewport, and depth, of a place in clip space.
vec2 pixels(vec4 place) { return place.xy / place.w * viewport.zw; }

vec2 unit(vec2 v) {
    float size = length(v);
    return size > 0.0 ? v / size : vec2(0.0);
}

// The direction on the screen of a direction in object space, at a place in clip space.
vec2 projected(vec3 way, vec4 place) {
    vec4 flow = projection * vec4(mat3(modelview) * way, 0.0);
    return unit((flow.xy * place.w - place.xy * flow.w) * viewport.zw);
}
