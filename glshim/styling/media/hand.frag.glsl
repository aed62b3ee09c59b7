// What:   the ink of one stroke of a hand.
// Inputs: the stroke (stroke.glsl), the hand (hand.glsl); ink; a brush's picture.
// Source: NPRQuake: sketch (translucent lines), blueprint (overshooting lines), brush (textured
//         quads).

uniform vec3 inks[GROUPS];
uniform float opacity;        // of one stroke
uniform float pressure;       // share of its width that a stroke swells and thins by
uniform float taper;          // pixels at the ends of strokes over which they grow thin
uniform float tip;            // pixels of a stroke in full width; shorter ones are thinner
uniform float textured;       // 1.0: with a brush
uniform float tiles;          // brushes for each repeat of the motion
uniform float tinted;         // 1.0: the brush is grey and takes the line's colour
uniform sampler2D stroke;     // premultiplied
uniform float begins;         // 1.0: a stroke begins anywhere in the picture; 0.0: where it does
uniform float bristles;       // pixels over which a brush's hairs leave the paper in turn

// Ink that the hairs of a brush lay down so many pixels after a stroke begins and before it ends,
// v across: they come down nearly together, and leave by how much ink each has.
float dabbed(float begun, float left, float v) {
    float most = bristles * share_of_motion();
    float dry = 1.0 - texture(stroke, vec2(chance(23.0) + 0.37 * floor(way() + 1.5), v)).a;
    float bent = most * (0.3 * dry + 0.25 * abs(2.0 * v - 1.0));
    float gone = smoothstep(0.0, 3.0 + 0.5 * most, left - most * dry - bent);
    return smoothstep(0.0, 3.0, begun - bent) * gone;
}

void main() {
    take_stroke();
    vec2 from_a = gl_FragCoord.xy - line_a.xy;
    float t = dot(from_a, along), s = dot(from_a, out_1);
    // As far as the stroke goes: on to the next line, or beyond its end.
    float first = hand.x < AT_END ? -hand.z : 0.0, last = span + (hand.y < AT_END ? hand.z : 0.0);
    float on = clamp(t, first, last), past = t - on;
    float at = repeat_at(on);
    s -= strays(on);

    vec2 ends = vec2(hand.x + on, hand.y + span - on) + hand.z;  // pixels to those of the stroke
    float left = min(ends.x, ends.y);
    float half_width = extent.y * (1.0 + pressure * motion(at, 11.0));
    half_width *= tip > 0.0 ? mix(0.3, 1.0, smoothstep(0.0, tip, stroke_length())) : 1.0;
    float tapered = min(taper, 0.3 * stroke_length());
    half_width *= taper > 0.0 ? mix(0.35, 1.0, smoothstep(0.0, tapered, left)) : 1.0;
    float off = length(vec2(past, s));
    // Finer than a pixel is fainter, not finer.
    float cover = clamp(max(half_width, 0.5) + 0.5 - off, 0.0, 1.0) * min(half_width / 0.5, 1.0);
    vec4 drawn = vec4(inks[group], 1.0);
    if (textured > 0.0) {
        vec2 place = vec2(tiles * at + begins * chance(5.0), 0.5 + 0.5 * way() * s / half_width);
        drawn = texture(stroke, place);
        if (tinted > 0.0) drawn.rgb *= inks[group];
        if (bristles > 0.0 && left < 4.0 * bristles)
            drawn *= way() < 0.0 ? dabbed(ends.y, ends.x, place.y)
                                 : dabbed(ends.x, ends.y, place.y);
    }
    drawn *= opacity * cover;
    if (drawn.a <= 0.002) discard;
    if (hand.w == 0.0 && !seen(clamp(t, 0.0, span))) discard;
    colour = drawn;
}
