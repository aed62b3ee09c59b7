// What:   the G-buffer: the normal in eye space, turned to the viewer, of length 2 where the material
//         gleams, else 1, and the window depth.
// Inputs: the surface's place and normal in eye space; the app's clip planes.
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
    // Smooth normals of what is seen may look away a little at an outline: the triangle itself says
    // which side is seen.
    vec3 side = cross(dFdx(spot), dFdy(spot)), sight = viewpoint.xyz - viewpoint.w * spot;
    side *= dot(side, sight) < 0.0 ? -1.0 : 1.0;
    vec3 n = dot(upright, upright) > 0.0 ? normalize(upright) : normalize(side);
    colour = vec4((1.0 + gleams) * (dot(n, side) < 0.0 ? -n : n), gl_FragCoord.z);
}
