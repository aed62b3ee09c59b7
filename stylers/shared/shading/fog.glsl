// What:   the app's fog: how much of a surface is seen through it.
// Inputs: glshim/model/fog.py, whose `clear_share` is the numpy reference.
// Source: The OpenGL Specification, version 2.1, section 3.10.

uniform int fog;           // 0: none, 1: linear, 2: exp, 3: exp2
uniform vec3 fog_terms;    // density, start, end
uniform vec3 fog_colour;
uniform vec3 fog_seen;     // what it is in the picture: the paper, where it was the background

// Share of the surface's own colour at a place in eye space.
float clear_share(vec3 spot) {
    float reach = abs(spot.z), span = fog_terms.z - fog_terms.y;
    if (fog == 0) return 1.0;
    if (fog == 1) return clamp((fog_terms.z - reach) / (span == 0.0 ? 1.0 : span), 0.0, 1.0);
    float thick = fog_terms.x * reach;
    return clamp(exp(-(fog == 2 ? thick : thick * thick)), 0.0, 1.0);
}

// A colour that the app drew, as it is without fog.
vec3 without_fog(vec3 shown, float clear) {
    vec3 own = clamp((shown - (1.0 - clear) * fog_colour) / max(clear, 0.004), 0.0, 1.0);
    return clear < 1.0 ? own : shown;
}

vec3 in_fog(vec3 found, float clear) { return mix(fog_seen, found, clear); }
