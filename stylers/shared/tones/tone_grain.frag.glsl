// What:   charcoal rubbed on paper: it stays on the tooth, the more of it the darker.
// Inputs: tone.glsl, held.glsl; the brightness of the app's picture.
// Source: A. Majumder, M. Gopi, "Hardware Accelerated Real Time Charcoal Rendering", NPAR 2002:
//         contrast is raised, and the paper's grain decides what is covered.

void main() {
    vec2 at = gl_FragCoord.xy, spot = on_paper(at);
    bool drawn = surface(at);
    if (!drawn && behind == 0) discard;
    float cover = 0.0;
    if (drawn) {
        float dark = pow(1.0 - smoothstep(0.0, 0.95, brightness(shown(at))), 1.3);
        // The stick goes along one way, the paper's tooth catches it.
        Held h = held_at(at);
        float grains = 0.15 * grain(spot).r + 0.4 * tooth(h, 0.6).r
                     + 0.45 * tooth(drawn_out(h, 8.0), 0.9).r;
        float sweep = cloud(drawn_out(h, 6.5), 0.4).g - 0.5;
        float press = dark * (1.0 + 0.35 * sweep) + 0.08 * sweep;
        float smear = 0.6 * press;  // what a finger rubs into the paper
        float caught = clamp((press - grains) / 0.55 + 0.45, 0.0, 1.0);
        cover = mix(smear, 0.92, caught * smoothstep(0.02, 0.5, press));
        cover = clamp(cover, 0.0, 0.95);
    }
    colour = vec4(mix(bare(spot), ink, cover), 1.0);
}
