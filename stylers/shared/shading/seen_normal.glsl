// What:   the normal by which a surface is lit, turned to the viewer.
// Inputs: of a fragment, in eye space: its place, the normal that was sent (zero: none), a vector
//         to the viewer. Takes derivatives: before any discard.

// Cosines between the sent normal and the triangle's own. Up to the first the sent one lies in the
// triangle's plane and says nothing of it (a floor under glNormal's default): which way it is
// turned would be rounding noise. From the second on it is a smooth surface's.
const float IN_PLANE = 0.05, SMOOTH = 0.25;

vec3 seen_normal(vec3 spot, vec3 sent, vec3 sight) {
    // Smooth normals of what is seen may look away a little at an outline: the triangle itself says
    // which side is seen.
    vec3 side = normalize(cross(dFdx(spot), dFdy(spot)));
    side *= dot(side, sight) < 0.0 ? -1.0 : 1.0;
    if (!(dot(sent, sent) > 0.0)) return side;
    vec3 n = normalize(sent);
    float facing = dot(n, side);
    return normalize(mix(side, facing < 0.0 ? -n : n, smoothstep(IN_PLANE, SMOOTH, abs(facing))));
}
