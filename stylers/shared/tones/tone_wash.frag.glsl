// What:   a watercolour wash: pale, uneven, with pigment that gathers at its borders and in the
//         grain.
// Inputs: tone.glsl, held.glsl.
// Source: A. Bousseau et al., "Interactive Watercolor Rendering with Temporal Coherence and
//         Abstraction", NPAR 2006: edges that wobble and darken, turbulence, and the paper, all of
//         which change the density of the pigment, here by Beer's law.

const int SPOKES = 10;
const float REACH = 4.0;  // pixels of the window to which pigment is carried
const float OVER = 2.5;   // pixels of the window by which washes run over outlines
const float WASHES = 1.7; // laid over each other, in a ratio of 2

// The nearest surface to a place, which the brush has run over from; the place itself if none is.
vec2 spilled(vec2 place) {
    vec2 found = place;
    bool dry = !surface(place);
    for (int k = 0; k < (dry ? SPOKES : 0); ++k) {
        float turn = 6.2832 * float(k) / float(SPOKES);
        vec2 there = place + shot.z * OVER * vec2(cos(turn), sin(turn));
        if (surface(there)) found = place + 2.0 * (there - place);
    }
    return surface(found) ? found : place;
}

void main() {
    vec2 at = gl_FragCoord.xy, spot = on_paper(at);
    if (behind == 0 && !surface(at)) discard;
    Held h = held_at(spilled(at));
    vec3 fine = cloud(h, 1.0), wide = cloud(h, 3.0);
    vec2 place = at + 5.0 * shot.z * (fine.gb - 0.5);
    if (behind == 1) place = spilled(place);
    else if (!surface(place)) place = at;
    vec3 sheet = bare(spot);
    if (!surface(place)) {
        colour = vec4(sheet, 1.0);
        return;
    }
    vec3 here = shown(place);
    float rim = 0.0;
    for (int k = 0; k < SPOKES; ++k) {
        float turn = 6.2832 * float(k) / float(SPOKES);
        float away = shot.z * (k % 2 == 0 ? REACH : 0.5 * REACH);
        vec2 there = place + away * vec2(cos(turn), sin(turn));
        rim += surface(there) ? min(distance(shown(there), here), 0.5) : 0.5;
    }
    rim /= float(SPOKES);
    // A few washes, each dried before the next: darker just within their borders.
    float value = max(max(here.r, here.g), max(here.b, 0.06));
    float level = WASHES * log2(value) + 0.35 * (wide.b - 0.5) + 0.25 * (fine.g - 0.5);
    float within = fract(level);
    float washed = floor(level) + 0.5 + smoothstep(0.8, 1.0, within);
    float dried = smoothstep(0.35, 0.8, within) * (1.0 - smoothstep(0.8, 0.98, within));
    vec3 pigment = here / value * mix(value, min(exp2(washed / WASHES), 1.0), 0.6);
    pigment = clamp(mix(vec3(brightness(pigment)), pigment, 1.35), 0.07, 0.98);
    float density = 0.58 + 0.5 * (wide.g - 0.5) + 0.3 * (fine.b - 0.5)
                  + 0.18 * (tooth(h, 0.6).r - 0.5)
                  + 0.12 * dried + 0.8 * smoothstep(0.05, 0.35, rim);
    colour = vec4(sheet * pow(pigment, vec3(max(density, 0.1))), 1.0);
}
