// What: the app's polygons as triangles, for both passes that look for polygons that cross.
// Inputs: a corner in object space; the camera.
// Source: Raskar 2001, section 2.4.

layout(location = 0) in vec3 corner;

uniform mat4 modelview;
uniform mat4 projection;
#if CLIP_PLANES > 0
uniform vec4 clip_planes[CLIP_PLANES];  // the app's, in eye space
out float gl_ClipDistance[CLIP_PLANES];
#endif

invariant gl_Position;  // both passes see the same depth

void main() {
    vec4 eye = modelview * vec4(corner, 1.0);
    gl_Position = projection * eye;
#if CLIP_PLANES > 0
    for (int i = 0; i < CLIP_PLANES; ++i) gl_ClipDistance[i] = dot(clip_planes[i], eye);
#endif
}
