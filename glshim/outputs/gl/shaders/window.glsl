// Prelude of line and mesh shaders: the camera, and what a line on the screen needs. Mirrored in
// numpy by glshim/geometry/raskar.py, which cites the papers and is held to this.

uniform mat4 projection;        // eye to clip
uniform mat4 unprojection;      // clip to eye
uniform vec4 viewpoint;         // the viewer in eye space: a point, or (w = 0) a direction to it
uniform vec4 viewport;          // pixels: its middle, and half its size
uniform vec2 range;             // window depth of the near and the far plane, turned by away
#ifndef CLIP_PLANES
#define CLIP_PLANES 0
#endif
#if CLIP_PLANES > 0
uniform vec4 clip_planes[CLIP_PLANES];  // the app's, in eye space
#endif

const vec4 NOWHERE = vec4(0.0, 0.0, 2.0, 1.0);

// Moves the ends of a side to where it crosses a plane. Whether something is left of it.
bool cut_by(vec4 plane, inout vec3 a, inout vec3 b) {
    float near_a = dot(plane, vec4(a, 1.0)), near_b = dot(plane, vec4(b, 1.0));
    if (near_a < 0.0 && near_b < 0.0) return false;
    vec3 crossing = near_a == near_b ? a : a + near_a / (near_a - near_b) * (b - a);
    if (near_a < 0.0) a = crossing;
    else if (near_b < 0.0) b = crossing;
    return true;
}

// Cuts off what lies before the near plane or outside the app's clip planes.
bool cut(inout vec3 a, inout vec3 b) {
    mat4 rows = transpose(projection);
    if (!cut_by(rows[2] + rows[3], a, b)) return false;
#if CLIP_PLANES > 0
    for (int i = 0; i < CLIP_PLANES; ++i) if (!cut_by(clip_planes[i], a, b)) return false;
#endif
    return true;
}

// Window coordinates of an eye-space point: pixels of the framebuffer, depth.
vec3 window(vec3 eye) {
    vec4 clip = projection * vec4(eye, 1.0);
    vec3 ndc = clip.xyz / (abs(clip.w) < 1e-30 ? 1e-30 : clip.w);
    return vec3(viewport.xy + ndc.xy * viewport.zw, mix(range.x, range.y, 0.5 * ndc.z + 0.5));
}

// Clip space of a place in the window, for a quad that no depth test touches.
vec4 on_screen(vec2 place) { return vec4((place - viewport.xy) / viewport.zw, 0.0, 1.0); }

// Window depth per pixel over the plane through an eye-space point: affine on the screen.
vec2 depth_slope(vec3 normal, vec3 point) {
    vec4 plane = vec4(normal, -dot(normal, point)) * unprojection;
    float z = abs(plane.z) < 1e-20 ? 1e-20 : plane.z;
    return -plane.xy / (z * viewport.zw) * 0.5 * (range.y - range.x);
}

// Window depth that a plane at 45 degrees to the line of sight gains in a pixel.
float pixel_depth(vec3 point, vec3 along) {
    vec3 sight = normalize(viewpoint.w * point - viewpoint.xyz);
    vec3 across = normalize(cross(sight, along));
    vec4 here = projection * vec4(point, 1.0);
    vec4 deeper = projection * vec4(sight, 0.0), aside = projection * vec4(across, 0.0);
    deeper = deeper * here.w - here * deeper.w;
    aside = aside * here.w - here * aside.w;
    float pixels = length(aside.xy * viewport.zw);
    return abs(0.5 * deeper.z * (range.y - range.x)) / max(pixels, 1e-30);
}
