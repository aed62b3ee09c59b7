// What:   the depth against which lines are drawn: all models with a depth offset.
// Inputs: receded.glsl.
// Source: McGuire & Hughes 2004, section 3.5.

void main() {
    colour = vec4(0.0);
    gl_FragDepth = away * receded(gl_FragCoord.xy);
}
