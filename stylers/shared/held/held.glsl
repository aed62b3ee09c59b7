// What:   patterns that lie on the object, as large on the screen at any distance, and nowhere
//         drawn out: solid textures, of which a surface cuts out its pattern, in octaves that take
//         turns.
// Inputs: tone.glsl; the G-buffer of held.frag.glsl.
// Source: P. Benard, A. Bousseau, J. Thollot, "Dynamic Solid Textures for Real-Time Coherent
//         Stylization", I3D 2009; K. Perlin, "An Image Synthesizer", SIGGRAPH 1985.

uniform sampler2D gbuffer;

const float LEVEL = 256.0;   // added to levels: zero is where no surface is known
const float UNLIT = 1024.0;  // the same for what the app drew without light
// No face of a box lies along an axis of the solid.
const mat3 ASKEW = mat3(0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6);
const vec3 ACROSS = vec3(0.62, 0.71, 0.34);  // strokes lie in planes across it

// Where a surface lies on its object, and log2 of its units in a pixel of the window.
struct Held {
    vec3 place;
    float level;
    bool known;  // else the place is one on the screen
    bool lit;    // the app lit it, as far as the style asks
};

Held held_at(vec2 place) {
    vec4 found = texelFetch(gbuffer, ivec2(clamp(place, port.xy, port.zw)), 0);
    if (found.w <= 0.0) return Held(vec3(on_paper(place), 0.0), 0.0, false, false);
    bool lit = found.w < 0.5 * (LEVEL + UNLIT);
    return Held(ASKEW * found.xyz, found.w - (lit ? LEVEL : UNLIT) + log2(shot.z), true, lit);
}

// What a place on the object gains in a pixel to the right, or upwards: the less of both sides, as
// another surface may lie beyond one.
vec3 gained(vec2 at, vec2 aside, Held h) {
    Held ahead = held_at(at + aside), behind = held_at(at - aside);
    vec3 one = ahead.place - h.place, other = h.place - behind.place;
    bool nearer = dot(one, one) < dot(other, other);
    bool first = ahead.known == h.known && (behind.known != h.known || nearer);
    return first ? one : other;
}

// The same with all lengths but those across drawn out to so many times as much.
Held drawn_out(Held h, float factor) {
    vec3 across = normalize(ACROSS);
    vec3 high = dot(h.place, across) * across;
    if (!h.known) high = vec3(-0.6, 0.8, 0.0) * dot(h.place, vec3(-0.6, 0.8, 0.0));
    h.place = high + (h.place - high) / factor;
    return h;
}

// A place of the grain at which its clouds are of a middling density: the middle of an object,
// about which all octaves are alike.
const vec2 MIDDLE = vec2(368.0, 348.0) / 512.0;

// The paper's grain as the slices of a solid, so many pixels of it apart.
vec3 solid(vec3 p, float apart) {
    float slice = floor(p.z / apart), part = p.z / apart - slice;
    const vec2 STEP = vec2(0.7548777, 0.5698403);
    vec2 here = p.xy / 512.0 + MIDDLE + slice * STEP, there = here + STEP;
    vec3 a = textureLod(stroke, fract(here), 0.0).rgb;
    vec3 b = textureLod(stroke, fract(there), 0.0).rgb;
    return (mix(a, b, part) - 0.5) * inversesqrt(part * part + (1.0 - part) * (1.0 - part));
}

// The grain on an object: 0..1, about so many times as large on the screen as on paper.
vec3 grain(Held h, float factor, float apart) {
    if (!h.known) return grain(h.place.xy, factor);
    float level = h.level + log2(factor), fine = floor(level);
    float part = smoothstep(0.0, 1.0, level - fine);
    vec3 p = h.place / exp2(fine);
    vec3 found = mix(solid(p, apart), solid(0.5 * p, apart), part);
    return clamp(0.5 + found * inversesqrt(part * part + (1.0 - part) * (1.0 - part)), 0.0, 1.0);
}

const float TOOTH = 2.5, CLOUD = 16.0;  // pixels of the grain from slice to slice

// The tooth keeps its bite, which interpolation takes from it.
vec3 tooth(Held h, float factor) {
    vec3 found = grain(h, factor, TOOTH);
    return h.known ? clamp(0.5 + 1.35 * (found - 0.5), 0.0, 1.0) : found;
}
vec3 cloud(Held h, float factor) { return grain(h, factor, CLOUD); }
