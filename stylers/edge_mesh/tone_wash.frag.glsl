// What:   a watercolour wash: pale, uneven, with pigment that gathers at its borders and in the grain.
// Inputs: tone.glsl.
// Source: A. Bousseau et al., "Interactive Watercolor Rendering with Temporal Coherence and
//         Abstraction", NPAR 2006: edges that wobble and darken, turbulence, and the paper, all of
//         which change the density of the pigment, C' = C - (C - C^2) (d - 1).

const int SPOKES = 12;
const float REACH = 4.5;  // pixels to which pigment is carried

vec3 wet(vec2 place) {
    return surface(place) ? shown(place) : vec3(2.0);
}

void main() {
    vec2 at = gl_FragCoord.xy;
    vec3 clouds = grain(at, 1.0), wide = grain(at, 3.0);
    vec2 place = at + 5.0 * (clouds.gb - 0.5);
    if (!surface(place)) {
        if (behind == 0 && !surface(at)) discard;
        colour = vec4(bare(at), 1.0);
        return;
    }
    vec3 here = shown(place), mean = vec3(0.0);
    float rim = 0.0;
    for (int k = 0; k < SPOKES; ++k) {
        float turn = 6.2832 * float(k) / float(SPOKES);
        vec3 there = wet(place + (k % 2 == 0 ? REACH : 0.5 * REACH) * vec2(cos(turn), sin(turn)));
        rim += min(distance(there, here), 0.6);
        mean += min(there, vec3(1.0));
    }
    rim /= float(SPOKES);
    mean /= float(SPOKES);
    // Water lifts colours and leaves them pure.
    float grey = brightness(here);
    vec3 pigment = clamp(mix(vec3(grey), here, 1.25), 0.03, 0.97);
    pigment = mix(paper, pigment, 0.78);
    float density = 1.0 + 1.1 * (wide.g - 0.5) + 0.5 * (clouds.b - 0.5) + 0.35 * (clouds.r - 0.5)
                  + 3.2 * smoothstep(0.03, 0.35, rim);
    vec3 laid = pigment - (pigment - pigment * pigment) * (density - 1.0);
    vec3 sheet = bare(at);
    colour = vec4(clamp(laid * sheet / paper, 0.0, 1.0), 1.0);
}
