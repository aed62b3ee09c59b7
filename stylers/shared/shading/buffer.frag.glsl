// What:   the G-buffer: the normal in eye space, turned to the viewer, and the window depth. The
//         normal's length is 1, and 1 more where the material gleams, and 2 more where GL lights
//         the side that is not seen.
// Inputs: seen_normal.glsl; the surface's place and normal in eye space; the app's clip planes.
// Source: Rideout 2010, "The Spine Test". He keeps normals in 0..1; here they are floats.

#if CLIP_PLANES > 0
uniform vec4 clip_planes[CLIP_PLANES];
#endif
uniform vec4 viewpoint;
uniform float gleams;      // 0 or 1
uniform float both_sides;  // 1: each side is lit by the normal that looks its way

in vec3 spot;
in vec3 upright;
in float sent;

void main() {
#if CLIP_PLANES > 0
    for (int i = 0; i < CLIP_PLANES; ++i) if (dot(clip_planes[i], vec4(spot, 1.0)) < 0.0) discard;
#endif
    vec3 n = seen_normal(spot, upright, viewpoint.xyz - viewpoint.w * spot);
    // A normal in its surface's plane says nothing of its sides.
    float facing = sent * dot(upright, n) / max(length(upright), 1e-30);
    float away = both_sides < 0.5 && facing < -0.5 ? 2.0 : 0.0;
    colour = vec4((1.0 + gleams + away) * n, gl_FragCoord.z);
}
