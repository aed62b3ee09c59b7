// What:   graphite or crayon rubbed into paper, by how dark the program's picture is.
// Inputs: tone.glsl, held.glsl.
// Source: M. C. Sousa, J. W. Buchanan, "Observational Models of Graphite Pencil Materials",
//         Computer Graphics Forum 2000: the tooth of the paper holds graphite, a blender rubs it
//         between.

uniform float strength;  // of the tone
uniform float coloured;  // share of the program's own colours

void main() {
    vec2 at = gl_FragCoord.xy, spot = on_paper(at);
    if (behind == 0 && !surface(at)) discard;
    vec3 sheet = bare(spot);
    Held h = held_at(at);
    vec3 wide = cloud(h, 2.2);
    vec2 place = at + 2.5 * shot.z * (wide.gb - 0.5);  // a blender does not stop sharply
    if (!surface(place)) place = at;
    if (!surface(place)) {
        colour = vec4(sheet, 1.0);
        return;
    }
    vec3 seen = shown(place);
    float value = max(max(seen.r, seen.g), max(seen.b, 0.05));
    float dark = 1.0 - smoothstep(0.0, 0.85, brightness(seen));
    // The side of the lead goes over the tooth, all one way.
    float sweep = cloud(drawn_out(h, 8.0), 1.0).g - 0.5;
    float grains = 0.3 * grain(spot).r + 0.3 * tooth(h, 0.6).r
                 + 0.25 * tooth(drawn_out(h, 3.2), 0.6).r + 0.15;
    vec3 hue = clamp(mix(vec3(brightness(seen / value)), seen / value, 1.25), 0.0, 1.0);
    float pure = 1.0 - min(min(hue.r, hue.g), hue.b);
    float press = strength * mix(dark, max(dark, 0.75 * pure + 0.5 * dark), coloured);
    press *= 0.95 + 0.3 * sweep + 0.2 * (wide.b - 0.5);
    float cover = 0.55 * press + 0.6 * press * smoothstep(-0.4, 0.4, 1.2 * press - grains);
    // Greys are the graphite's own.
    vec3 crayon = mix(ink, hue * mix(1.0, value, 0.55), smoothstep(0.05, 0.3, pure));
    vec3 pigment = mix(ink, crayon * mix(0.92, 1.0, cloud(h, 1.0).g), coloured);
    colour = vec4(mix(sheet, pigment * mix(vec3(1.0), sheet, 0.35), clamp(cover, 0.0, 0.95)), 1.0);
}
