// What:   the G-buffer: the normal in eye space, turned to the viewer, of length 2 where the material
//         gleams, else 1, and the window depth.
// Inputs: seen_normal.glsl; the surface's place and normal in eye space; the app's clip planes.
// Source: Rideout 2010, "The Spine Test". He keeps normals in 0..1; here they are floats.

#if CLIP_PLANES > 0
uniform vec4 clip_planes[CLIP_PLANES];
#endif
uniform vec4 viewpoint;
uniform float gleams;  // 0 or 1

in vec3 spot;
in vec3 upright;

void main() {
#if CLIP_PLANES > 0
    for (int i = 0; i < CLIP_PLANES; ++i) if (dot(clip_planes[i], vec4(spot, 1.0)) < 0.0) discard;
#endif
    vec3 n = seen_normal(spot, upright, viewpoint.xyz - viewpoint.w * spot);
    colour = vec4((1.0 + gleams) * n, gl_FragCoord.z);
}
