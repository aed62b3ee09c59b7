// What:   the program's picture painted over in dabs of a brush, each of one of its colours.
// Inputs: tone.glsl; the app's finished picture and depth.
// Source: P. Haeberli, "Paint by Numbers: Abstract Image Representations", SIGGRAPH 1990: dabs on a
//         jittered grid; B. Meier, "Painterly Rendering for Animation", SIGGRAPH 1996: large dabs
//         first, light and dark varied a little; P. Litwinowicz, "Processing Images and Video for an
//         Impressionist Effect", SIGGRAPH 1997: along contours of brightness, clipped at edges.

uniform float tint;      // how much of the paper the paint covers
uniform float dab;       // pixels of a dab's length
uniform float dab_seed;  // a number for each painting

const float SPILL = 2.5;  // pixels by which paint runs over outlines

vec3 chances(vec2 cell) {
    vec3 p = fract(vec3(cell.xyx) * vec3(0.1031, 0.1030, 0.0973) + 0.0717 * dab_seed);
    p += dot(p, p.yxz + 33.33);
    return fract((p.xxy + p.yzz) * p.zyx);
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

// Lays the dabs of one size over what is painted: premultiplied. edge: what is shown there, or
// nearly there; dabs of quite another colour stop. rows: 2 of cells; 0: none (drivers in software
// leave loops early, but walk through every branch).
vec4 dabbed(vec4 under, vec2 at, vec3 edge, float size, float number, float rows) {
    float apart = 0.78 * size;  // no dab reaches beyond the four cells about a pixel
    vec2 home = floor(at / apart - 0.5);
    for (float j = 0.0; j < rows; j += 1.0) {
        for (float i = 0.0; i < 1.5; i += 1.0) {
            vec2 cell = home + vec2(i, j);
            vec3 chance = chances(cell + 57.0 * number);
            vec2 middle = floor((cell + 0.15 + 0.7 * chance.xy) * apart) + 0.5;
            if (!surface(middle)) continue;
            vec3 pigment = shown(middle);
            vec2 way = lie(middle, brightness(pigment), 0.3 * size, 0.9 * (chance.z - 0.5));
            vec2 off = at - middle;
            vec2 place = vec2(dot(off, way), dot(off, vec2(-way.y, way.x))) / (0.5 * size);
            place.y *= 1.7;
            // The hairs: streaks along the dab, which end raggedly.
            float hair = grain(vec2(6.0 * place.x, 16.0 * place.y) + 211.0 * chance.xy, 1.0).r;
            float rim = length(place) + 0.35 * (hair - 0.5) * (0.4 + abs(place.x));
            float cover = 1.0 - smoothstep(0.78, 0.98, rim);
            if (cover <= 0.0) continue;
            cover *= 1.0 - smoothstep(0.16, 0.34, distance(pigment, edge));
            pigment *= 1.0 + 0.16 * (chance.z - 0.5) + 0.12 * (hair - 0.5);
            under = mix(under, vec4(pigment, 1.0), cover * (0.86 + 0.14 * hair));
        }
    }
    return under;
}

void main() {
    vec2 at = gl_FragCoord.xy;
    bool within = surface(at);
    if (behind == 0 && !within) discard;
    vec3 sheet = bare(at);
    vec4 paint = vec4(0.0);
    bool near = within;
    for (int k = 0; k < (near ? 0 : 8); ++k) {
        float turn = 0.7854 * float(k);
        near = near || surface(at + SPILL * (0.4 + grain(at, 2.0).g) * vec2(cos(turn), sin(turn)));
    }
    vec2 beside = at + 5.0 * (grain(at, 1.0).gb - 0.5);
    vec3 edge = surface(beside) ? shown(beside) : shown(at);
    if (within) paint = vec4(shown(at), 1.0) * 0.97;
    float rows = near && tint > 0.0 ? 2.0 : 0.0;
    paint = dabbed(paint, at, edge, 1.6 * dab, 1.0, rows);
    paint = dabbed(paint, at, edge, dab, 2.0, rows);
    // As thick paint is: a little purer than the program's.
    float grey = brightness(paint.rgb);
    paint.rgb = clamp(mix(vec3(grey), paint.rgb, 1.25), 0.0, paint.a);
    float tooth = 1.0 - 0.1 * (grain(at).r - 0.5);
    colour = vec4(mix(sheet, sheet * (1.0 - paint.a) + paint.rgb * tooth, tint), 1.0);
}
