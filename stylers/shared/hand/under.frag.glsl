// What:   paper under everything, and of the program's picture so much as the style leaves.
// Inputs: tone.glsl; the app's finished picture.
// Source: NPRQuake's sketch and blueprint lay their paper first and fill all surfaces with it.

uniform float tint;   // of the picture's colours on surfaces, 0..1
uniform float shade;  // of its brightness, towards light ink or dark
uniform float grid;   // pixels from line to line of printed paper; 0: plain
uniform float tooth;  // of the paper's own grain, 0..1
uniform vec3 rule;    // colour of its lines

void main() {
    vec2 at = gl_FragCoord.xy;
    if (behind == 0 && !surface(at)) discard;
    vec3 sheet = mix(paper, bare(on_paper(at)), tooth);
    vec2 ruled = at + shot.xy;
    if (grid > 0.0) {
        vec2 off = abs(fract(ruled / grid) - 0.5) * grid;
        vec2 wide = abs(fract(ruled / (5.0 * grid)) - 0.5) * 5.0 * grid;
        float lines = max(0.45 * step(0.5 * grid - 0.5 * shot.z, max(off.x, off.y)),
                          0.9 * step(2.5 * grid - 0.5 * shot.z, max(wide.x, wide.y)));
        sheet = mix(sheet, rule, lines);
    }
    if (surface(at)) {
        vec3 seen = shown(at);
        float value = max(max(seen.r, seen.g), seen.b);
        vec3 hue = seen / max(value, 1e-3);
        sheet *= mix(vec3(1.0), pow(hue, vec3(0.8)) * mix(1.0, value, 0.6), tint);
        float light = brightness(seen);
        vec3 shaded = brightness(paper) < 0.5 ? sheet + 0.35 * light : sheet * (0.55 + 0.5 * light);
        sheet = mix(sheet, shaded, shade);
    }
    colour = vec4(clamp(sheet, 0.0, 1.0), 1.0);
}
