// What:   charcoal rubbed on paper: it stays on the tooth, the more of it the darker.
// Inputs: tone.glsl; the brightness of the app's picture.
// Source: A. Majumder, M. Gopi, "Hardware Accelerated Real Time Charcoal Rendering", NPAR 2002:
//         contrast is raised, and the paper's grain decides what is covered.

void main() {
    vec2 at = gl_FragCoord.xy;
    bool drawn = surface(at);
    if (!drawn && behind == 0) discard;
    float cover = 0.0;
    if (drawn) {
        vec3 coarse = grain(at, 1.0);
        float dark = 1.0 - smoothstep(0.0, 0.85, brightness(shown(at)));
        // Rubbed along one way, unevenly.
        float sweep = grain(vec2(0.8 * at.x + 0.6 * at.y, 0.12 * (0.8 * at.y - 0.6 * at.x)), 0.35).g;
        float press = dark + 0.22 * (sweep - 0.5) * (1.0 - dark) + 0.1 * (coarse.g - 0.5);
        float smear = 0.45 * press;  // what a finger rubs into the paper
        float caught = clamp((press - coarse.r) / 0.3 + 0.35, 0.0, 1.0);
        cover = clamp(mix(smear, 0.95, caught * smoothstep(0.0, 0.25, press)), 0.0, 0.96);
    }
    colour = vec4(mix(bare(at), ink, cover), 1.0);
}
