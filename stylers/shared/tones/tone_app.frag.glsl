// What:   the app's surfaces on paper.
// Inputs: tone.glsl.

void main() {
    if (surface(gl_FragCoord.xy) || behind == 0) discard;
    colour = vec4(bare(on_paper(gl_FragCoord.xy)), 1.0);
}
