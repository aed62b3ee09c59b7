// What:   hatching with a pen: lines that swell where it is darker, crossed where it is darker still.
// Inputs: tone.glsl; the brightness of the app's picture.
// Source: G. Winkenbach, D. Salesin, "Computer-Generated Pen-and-Ink Illustration", SIGGRAPH 1994:
//         tone is made of strokes, whose width and number say how dark it is.

const float APART = 5.5;  // pixels of the window between lines

// Ink of one set of lines. way: a unit vector across them; dark: 0..1 of the paper to cover.
float lines(vec2 spot, vec2 way, float dark) {
    vec2 wander = grain(spot, 2.0).gb - 0.5;
    float across = dot(spot, way) / APART + 0.9 * wander.x;
    float press = 1.0 + 0.5 * wander.y + 0.12 * (grain(spot).r - 0.5);
    float off = abs(fract(across) - 0.5) * APART;
    float half_width = 0.5 * APART * clamp(dark, 0.0, 0.5) * press;
    // A pen leaves no line that is finer than its tip: it lifts.
    return clamp((half_width - off) * shot.z + 0.5, 0.0, 1.0) * smoothstep(0.25, 0.5, half_width);
}

void main() {
    vec2 at = gl_FragCoord.xy, spot = on_paper(at);
    bool drawn = surface(at);
    if (!drawn && behind == 0) discard;
    float cover = 0.0;
    if (drawn) {
        float dark = 1.0 - smoothstep(0.02, 0.8, brightness(shown(at)));
        cover = lines(spot, vec2(0.6, 0.8), 0.62 * dark - 0.08);
        cover = max(cover, lines(spot, vec2(-0.8, 0.6), 0.75 * dark - 0.4));
        cover = max(cover, lines(spot, vec2(0.995, 0.1), 1.2 * dark - 0.82));
        cover = max(cover, smoothstep(0.93, 0.98, dark));  // black is filled in
    }
    colour = vec4(mix(bare(spot), ink, cover), 1.0);
}
