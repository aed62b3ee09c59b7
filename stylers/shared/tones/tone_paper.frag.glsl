// What:   plain paper: lines alone are drawn on it.
// Inputs: tone.glsl.

void main() {
    if (behind == 0 && !surface(gl_FragCoord.xy)) discard;
    colour = vec4(bare(on_paper(gl_FragCoord.xy)), 1.0);
}
