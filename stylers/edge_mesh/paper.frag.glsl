// What:   ink: as it is, from a texture, dashed or dimmed.
// Inputs: a place on a stroke (paper.glsl); what the lines look like; receded.glsl.
// Source: McGuire & Hughes 2004, sections 3.5 and 4.

uniform sampler2D stroke;   // along, and across with the inside in its first row
uniform int textured;       // 1: ink from the texture, 2: with its own colours
uniform float strength;     // of the ink
uniform int hidden;         // 1: lines behind something: where their middle is
uniform int dashed;

flat in vec3 ink;
noperspective in vec2 grain;
noperspective in vec2 middle;
#ifdef ROUND
noperspective in vec2 reached;
flat in vec2 extent;
#endif

void main() {
    float cover = strength;
#ifdef ROUND
    float beyond_end = max(max(-reached.x, reached.x - extent.x), 0.0);
    cover *= clamp(extent.y + 0.5 - length(vec2(beyond_end, reached.y)), 0.0, 1.0);
    if (cover <= 0.0) discard;
#endif
    if (dashed == 1 && abs(fract(grain.x) - 0.5) > 0.28) discard;  // a dash around 0.5
    if (hidden == 1 && away * gl_FragCoord.z <= receded(floor(middle) + 0.5)) discard;
    vec4 drawn = vec4(1.0);
    if (textured > 0) drawn = texture(stroke, vec2(grain.x, 1.0 - grain.y));
    colour = cover * (textured == 2 ? drawn : vec4(ink * drawn.a, drawn.a));
}
