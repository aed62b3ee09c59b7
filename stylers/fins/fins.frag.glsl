// What:   ink on a fin, smooth at its rim, where its spine is seen.
// Inputs: stroke.glsl; the fin (fins.geom.glsl).
// Source: Rideout 2010, "Antialiased Fins", "The Spine Test" (F. Cole, A. Finkelstein 2010).

uniform vec3 ink;
uniform float half_width;
uniform float tip;      // pixels over which the ink fades at the rim; 0: none
uniform int spine;      // 1: the depth of the middle decides for all of the width
uniform int joints;

uniform int textured;   // 1: ink from the texture, 2: with its own colours
uniform sampler2D stroke;  // along, and across with the inside in its first row
uniform float repeat;   // pixels after which the texture repeats

noperspective in vec3 reach;

const int ROUND_JOINTS = 2;

void main() {
    take_stroke();
    float on = clamp(reach.x, 0.0, span);
    float d = joints == ROUND_JOINTS ? length(vec2(reach.x - on, reach.y)) : abs(reach.y);
    // Of the signed distance, which has no kink at the spine, and by its direction: fwidth adds up
    // the changes along x and y.
    float fade = tip * fwidth(reach.y) / (abs(along.x) + abs(along.y));
    float alpha = d > half_width ? 0.0 : 1.0;
    if (fade > 0.0) alpha = clamp((half_width - d) / fade, 0.0, 1.0);
    vec4 drawn = vec4(ink, 1.0);
    if (textured > 0) {
        // Cut out of the screen: a fin does not know how long the contour is before it.
        vec2 along_it = abs(along.y) > abs(along.x) ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
        float v = 0.5 + 0.5 * reach.y / half_width;
        vec4 found = texture(stroke, vec2(dot(gl_FragCoord.xy + shot.xy, along_it) / repeat, v));
        drawn = textured == 2 ? found : vec4(ink * found.a, found.a);
    }
    alpha *= drawn.a > 0.0 ? 1.0 : 0.0;
    if (alpha <= 0.0) discard;
    // Of five places about this one (`seen`) none lies beyond an end: caps are as their fin is.
    float inside = clamp(on, min(2.0, 0.5 * span), max(span - 2.0, 0.5 * span));
    if (spine == 1 ? !seen(inside) : finished(gl_FragCoord.xy) < reach.z - hair)
        discard;
    colour = alpha * drawn;
}
