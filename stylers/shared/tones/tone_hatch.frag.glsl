// What:   hatching with a pen: lines that swell where it is darker, crossed where it is darker
//         still.
// Inputs: tone.glsl, held.glsl; the brightness of the app's picture.
// Source: G. Winkenbach, D. Salesin, "Computer-Generated Pen-and-Ink Illustration", SIGGRAPH 1994:
//         tone is made of strokes, whose width and number say how dark it is. As in hatch.frag.glsl
//         they lie in planes through the object.

const float APART = 5.5;  // pixels of the window between lines
const float EVEN = 0.45;  // ink of a wash, where there is no light to hatch by

// Where a pixel lies across a set of lines, how much of that a pixel gains, and 0..1 whether that
// is enough: a surface across the direction has no lines, one nearly so would have them anywhere.
struct Across { float place, slope, share; };

Across across(Held h, vec3 right, vec3 up, vec3 way) {
    float slope = max(length(vec2(dot(right, way), dot(up, way))), 1e-12);
    float share = smoothstep(0.12, 0.3, slope / exp2(h.level - log2(shot.z)));
    return Across(dot(h.place, way), slope, h.known ? share : 1.0);
}

// Ink of one set of lines. dark: 0..1 of the paper to cover.
float lines(Across a, float dark, vec3 wander) {
    float apart = APART * shot.z, level = log2(apart * a.slope);
    float fine = floor(level), part = level - fine;
    float pixel = exp2(fine) / a.slope;  // from line to line: apart / 2 .. apart; half of them fade
    float at = a.place / exp2(fine) + 0.9 * wander.x * apart / pixel, nearest = floor(at + 0.5);
    bool odd = mod(nearest, 2.0) > 0.5;
    float swell = 1.0 + 0.5 * wander.y + 0.12 * wander.z;
    float half_width = clamp(dark, 0.0, 0.5) * pixel / (2.0 - part) * swell;
    if (odd) half_width *= 1.0 - part;
    float off = abs(at - nearest) * pixel;
    // A pen leaves no line that is finer than its tip: it lifts.
    float cover = clamp(half_width - off + 0.5, 0.0, 1.0);
    return cover * smoothstep(0.25, 0.5, half_width / shot.z) * a.share;
}

void main() {
    vec2 at = gl_FragCoord.xy, spot = on_paper(at);
    bool drawn = surface(at);
    if (!drawn && behind == 0) discard;
    float cover = 0.0;
    if (drawn) {
        float dark = 1.0 - smoothstep(0.02, 0.8, brightness(shown(at)));
        Held h = held_at(at);
        vec3 right = gained(at, vec2(1.0, 0.0), h), up = gained(at, vec2(0.0, 1.0), h);
        vec3 wander = vec3(cloud(h, 2.0).gb, tooth(h, 1.0).r) - 0.5;
        Across first = across(h, right, up, h.known ? normalize(ACROSS) : vec3(0.6, 0.8, 0.0));
        vec3 way = h.known ? normalize(vec3(-0.75, 0.58, 0.31)) : vec3(-0.8, 0.6, 0.0);
        Across second = across(h, right, up, way);
        way = h.known ? normalize(vec3(0.2, 0.45, -0.87)) : vec3(0.995, 0.1, 0.0);
        Across third = across(h, right, up, way);
        // A face across the first direction has no lines of it: those of the second take their
        // turn.
        cover = lines(first, 0.62 * dark - 0.08, wander);
        float instead = (1.0 - first.share) * (0.62 * dark - 0.08);
        cover = max(cover, lines(second, max(0.75 * dark - 0.4, instead), wander));
        cover = max(cover, lines(third, 1.2 * dark - 0.82, wander));
        cover = h.lit ? cover : EVEN * dark;
        cover = max(cover, smoothstep(0.93, 0.98, dark));  // black is filled in
    }
    colour = vec4(mix(bare(spot), ink, cover), 1.0);
}
