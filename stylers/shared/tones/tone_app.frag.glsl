// What:   the app's surfaces on paper, and scenery without depth, as pale as the style has it.
// Inputs: tone.glsl.

uniform float scenery;  // share of its own colours

void main() {
    vec2 at = gl_FragCoord.xy;
    if (solid(at) || behind == 0) discard;
    vec3 sheet = bare(on_paper(at));
    colour = vec4(surface(at) ? mix(sheet, shown(at), scenery) : sheet, 1.0);
}
