// Prelude of every line shader: the line record, the camera, and what a line on the screen needs.
// Mirrored in numpy by glshim/geometry/raskar.py, which cites the papers and is held to this.

layout(location = 0) in vec3 edge_a;      // object space: the side runs from a
layout(location = 1) in vec3 edge_b;      // to b,
layout(location = 2) in vec3 edge_c;      // and the polygon turns towards c
layout(location = 3) in vec4 edge_plane;  // unit normal of the winding, -(its dot with the centroid)
layout(location = 4) in vec2 edge_kind;   // RING ..., and the winding in the window: +1 ccw, -1 cw

uniform mat4 modelview;         // object to eye
uniform mat4 projection;        // eye to clip
uniform mat4 unprojection;      // clip to eye
uniform mat3 normal_matrix;     // cofactors of modelview
uniform vec4 viewpoint;         // the viewer in eye space: a point, or (w = 0) a direction to it
uniform vec2 half_viewport;     // pixels
uniform vec2 range;             // window depth of the near and the far plane
uniform bool spines;            // whether fragments can look up the layer's finished depth
uniform float hair;             // a few steps of the depth buffer, in ndc, signed: + is away

#if CLIP_PLANES > 0
uniform vec4 clip_planes[CLIP_PLANES];  // the app's, in eye space
out float gl_ClipDistance[CLIP_PLANES];
void clip_as_the_app(vec4 eye) {
    for (int i = 0; i < CLIP_PLANES; ++i) gl_ClipDistance[i] = dot(clip_planes[i], eye);
}
#else
void clip_as_the_app(vec4 eye) {}
#endif

const int RING = 0, RIDGE = 1, LONE_RIDGE = 2, FIN = 3;  // glshim/geometry/lines.py
const vec4 NOWHERE = vec4(0.0, 0.0, 2.0, 1.0);

// How far to move a clip-space point p towards q for it not to lie before the near plane, 0..1.
float near_cut(vec4 p, vec4 q) {
    float dp = p.z + p.w, dq = q.z + q.w;
    return dp < 0.0 && dq > 0.0 ? dp / (dp - dq) : 0.0;
}

// Clip space to pixels from the middle of the viewport.
vec2 pixels(vec4 clip) { return clip.xy / clip.w * half_viewport; }

// Whether a plane through an eye-space point shows the side of its normal to the viewer (> 0).
float facing(vec3 normal, vec3 point) {
    return dot(normal, viewpoint.xyz) - dot(normal, point) * viewpoint.w;
}

// Depth (ndc) per pixel over the plane through an eye-space point: depth is affine on the screen.
vec2 depth_slope(vec3 normal, vec3 point) {
    vec4 plane = vec4(normal, -dot(normal, point)) * unprojection;
    float z = abs(plane.z) < 1e-20 ? 1e-20 : plane.z;
    return -plane.xy / (z * half_viewport);
}
