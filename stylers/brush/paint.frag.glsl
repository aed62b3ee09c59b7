// What:   the program's picture painted over in dabs of a brush, each of one of its colours.
// Inputs: tone.glsl, held.glsl; the app's finished picture and depth.
// Source: P. Haeberli, "Paint by Numbers: Abstract Image Representations", SIGGRAPH 1990: dabs on a
//         jittered grid, here of the object; B. Meier, "Painterly Rendering for Animation",
//         SIGGRAPH 1996: dabs on surfaces, large ones first, light and dark varied a little; P.
//         Litwinowicz, "Processing Images and Video for an Impressionist Effect", SIGGRAPH 1997:
//         along contours of brightness, clipped at edges.

uniform float tint;      // how much of the paper the paint covers
uniform float dab;       // pixels of a dab's length
uniform float dab_seed;  // a number for each painting

const float SIZE = 1.3;   // of the smaller dabs, at most
const float SPILL = 2.5;  // pixels of the window by which paint runs over outlines

vec4 chances(vec3 cell) {
    const vec4 PRIMES = vec4(0.1031, 0.1030, 0.0973, 0.1099);
    vec4 p = fract(mod(cell, 1024.0).xyzx * PRIMES + 0.0717 * dab_seed);
    p += dot(p, p.wzxy + 33.33);
    return fract((p.xxyz + p.yzzw) * p.zywx);
}

// A surface about a pixel: its place on the object, which holds the dabs.
struct About {
    Held held;
    vec3 right, up;  // what it gains in a pixel
    vec3 normal;
    vec3 inverse;    // of the matrix of both products
};

About about(vec2 at) {
    Held h = held_at(at);
    vec3 right = gained(at, vec2(1.0, 0.0), h), up = gained(at, vec2(0.0, 1.0), h);
    vec3 n = cross(right, up);
    float a = dot(right, right), b = dot(right, up), c = dot(up, up);
    vec3 inverse = vec3(c, -b, a) / max(a * c - b * b, 1e-4 * max(a * a, c * c));
    return About(h, right, up, n / max(length(n), 1e-30), inverse);
}

// Which way a dab lies: across the slope of brightness about it; where there is none, up the right.
vec2 lie(vec2 place, float here, float reach, float turn) {
    float right = brightness(shown(place + vec2(reach, 0.0))) - here;
    float up = brightness(shown(place + vec2(0.0, reach))) - here;
    // A step is another thing's border.
    vec2 way = vec2(-up, right) * step(abs(right) + abs(up), 0.25);
    way *= way.x + way.y < 0.0 ? -1.0 : 1.0;
    way = normalize(way + 0.05 * vec2(0.8, 0.6));
    float c = cos(turn), s = sin(turn);
    return vec2(c * way.x - s * way.y, s * way.x + c * way.y);
}

// Lays the dabs of one size over what is painted: premultiplied. A dab is what the surface cuts out
// of a ball about a place in one of the object's cells. edge: what is shown there, or nearly there;
// dabs of quite another colour stop. size: units of the object; pixel: units in one; there: 0..1,
// how many of them are there; rows: 2 of cells; 0: none (drivers in software leave loops early, but
// walk through every branch).
vec4 dabbed(vec4 under, vec2 at, About a, vec3 edge,
            float size, float pixel, float there, float rows) {
    float apart = 0.78 * size;  // no dab reaches beyond the eight cells about a pixel
    vec3 home = floor(a.held.place / apart - 0.5);
    float number = log2(size);
    for (float k = 0.0; k < rows; k += 1.0) for (float j = 0.0; j < rows; j += 1.0)
        for (float i = 0.0; i < rows; i += 1.0) {
            vec3 cell = home + vec3(i, j, k);
            vec4 chance = chances(cell + 57.0 * number);
            vec3 off = a.held.place - (cell + 0.15 + 0.7 * chance.xyz) * apart;
            float grown = clamp(4.0 * (there - 0.75 * chance.w), 0.0, 1.0);
            float high = dot(off, a.normal), reach = 0.5 * size * grown;
            if (grown <= 0.0 || dot(off, off) > 1.4 * reach * reach) continue;
            // Its middle on the surface, and where that is seen.
            vec3 middle = a.held.place - off + high * a.normal, step_to = high * a.normal - off;
            vec2 along = vec2(dot(a.right, step_to), dot(a.up, step_to));
            vec2 spot = at + vec2(dot(a.inverse.xy, along), dot(a.inverse.yz, along));
            if (!surface(spot)) continue;
            Held found = held_at(spot);
            if (found.known != a.held.known || distance(found.place, middle) > 0.3 * size) continue;
            vec3 pigment = shown(spot);
            float turn = fract(7.0 * chance.w);
            vec2 way = lie(spot, brightness(pigment), 0.3 * size / pixel, 0.9 * (turn - 0.5));
            vec3 forward = normalize(way.x * a.right + way.y * a.up);
            vec3 aside = cross(a.normal, forward);
            vec3 place = vec3(dot(off, forward), 1.7 * dot(off, aside), 1.2 * high) / reach;
            // The hairs: streaks along the dab, which end raggedly.
            float hair = grain(vec2(6.0 * place.x, 16.0 * place.y) + 211.0 * chance.xy, 1.0).r;
            float rim = length(place) + 0.35 * (hair - 0.5) * (0.4 + abs(place.x));
            float cover = 1.0 - smoothstep(0.78, 0.98, rim);
            if (cover <= 0.0) continue;
            cover *= 1.0 - smoothstep(0.16, 0.34, distance(pigment, edge));
            pigment *= 1.0 + 0.16 * (turn - 0.5) + 0.12 * (hair - 0.5);
            under = mix(under, vec4(pigment, 1.0), cover * (0.86 + 0.14 * hair));
        }
    return under;
}

void main() {
    vec2 at = gl_FragCoord.xy, spot = on_paper(at);
    bool within = surface(at);
    if (behind == 0 && !within) discard;
    vec3 sheet = bare(spot);
    vec4 paint = vec4(0.0);
    bool near = within;
    for (int k = 0; k < (near ? 0 : 8); ++k) {
        float turn = 0.7854 * float(k);
        float reach = shot.z * SPILL * (0.4 + grain(spot, 2.0).g);
        near = near || surface(at + reach * vec2(cos(turn), sin(turn)));
    }
    About a = about(at);
    vec2 beside = at + 5.0 * shot.z * (cloud(a.held, 1.0).gb - 0.5);
    vec3 edge = surface(beside) ? shown(beside) : shown(at);
    if (within) paint = vec4(shown(at), 1.0) * 0.97;
    float rows = near && tint > 0.0 ? 2.0 : 0.0;
    // Of sizes that double two are there at a time, so that dabs on the screen keep theirs.
    float pixel = exp2(a.held.level), level = log2(SIZE * dab * pixel);
    float fine = floor(level), part = level - fine;
    paint = dabbed(paint, at, a, edge, exp2(fine + 1.0), pixel, smoothstep(0.0, 0.6, part), rows);
    paint = dabbed(paint, at, a, edge, exp2(fine), pixel, 1.0 - smoothstep(0.4, 1.0, part), rows);
    // As thick paint is: a little purer than the program's.
    float grey = brightness(paint.rgb);
    paint.rgb = clamp(mix(vec3(grey), paint.rgb, 1.25), 0.0, paint.a);
    float bite = 1.0 - 0.1 * (tooth(a.held, 0.6).r - 0.5);
    colour = vec4(mix(sheet, sheet * (1.0 - paint.a) + paint.rgb * bite, tint), 1.0);
}
