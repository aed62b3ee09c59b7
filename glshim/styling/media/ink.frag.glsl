// What:   ink on the pixels of one stroke, as much as it covers, where its line is seen.
// Inputs: the stroke (stroke.glsl); ink; a texture along and across the stroke. GLSL 1.20.
// Source: Raskar 2001, section 2.1.

uniform vec3 inks[GROUPS];
uniform float textured;       // 1.0: lines that a pattern repeats along are drawn with a texture
uniform sampler2D stroke;     // premultiplied; repeats along, from the inside (0) to the outside
uniform float tinted;         // 1.0: the texture is grey and takes the line's colour
uniform float dashes;         // of what is hidden, for each repeat of the pattern; 0.0: no dashes

const float JOINT = 0.02;     // pixels by which strokes of a chain overlap against rounding
const float LEAN = 1.5;       // pixels' worth of depth by which a line comes nearer in each pixel
const float WALL = 10.0;      // the same over the walls of a valley

// Share of a pixel off the line by s outwards, by past beyond its ends, that the stroke covers.
float covered(float s, float past, vec2 from_b) {
    if (abs(past) < JOINT) past = 0.0;
    float rim = clamp(extent.y + 0.5 - length(vec2(past, s)), 0.0, 1.0);
    if (kind > FIN) return rim;
    if (past == 0.0)
        return clamp(extent.y + 0.5 - s, 0.0, 1.0) * clamp(s - extent.x + 0.5, 0.0, 1.0);
    return past > 0.0 && dot(from_b, onwards) < 0.0 ? rim : 0.0;
}

// The ink at t along and s outwards. Round an outer corner of an outline the pattern runs on in its
// middle (glshim/linework/walk.py).
vec4 drawn_at(float t, float s) {
    if (textured == 0.0) return vec4(inks[group], 1.0);
    float on = t, off = s, past = t - span;
    if (kind <= FIN) {
        on = past <= 0.0 ? t : span + 0.5 * (extent.x + extent.y) * atan(past, s);
        off = past <= 0.0 ? s : length(vec2(past, s));
    }
    vec2 place = vec2(mix(repeats.x, repeats.y, on / span),
                      (off - extent.x) / (extent.y - extent.x));
    vec4 found = texture(stroke, place);
    if (tinted > 0.0) found.rgb *= inks[group];
    return repeats.x == repeats.y ? vec4(inks[group], 1.0) : found;
}

// Share of the ink of a hidden line t along.
float hidden_at(float t) {
    float each = dashes * abs(repeats.y - repeats.x) / span;  // dashes a pixel
    if (each == 0.0) return hidden_share;
    float place = dashes * mix(repeats.x, repeats.y, t / span);
    float beyond = abs(fract(place) - 0.5) - 0.3;
    return hidden_share * clamp(0.5 - beyond / each, 0.0, 1.0);
}

void main() {
    vec2 from_a = gl_FragCoord.xy - line_a.xy;
    take_stroke();
    float t = dot(from_a, along), s = dot(from_a, out_1), on = clamp(t, 0.0, span);
    float cover = covered(s, t - on, gl_FragCoord.xy - line_b.xy);
    vec4 drawn = drawn_at(t, s);  // before any discard: it takes derivatives
    if (cover * drawn.a <= 0.0) discard;

    bool shown = true;
    float off = length(vec2(t - on, s));
    if (off > 0.75) {  // nearer, the line itself decides
        vec3 place = point(on);
        vec2 aside = gl_FragCoord.xy - place.xy;
        float nearest = place.z + min(surface(aside), 0.0) - grain.y;
        bool wall = kind == LONE_VALLEY || kind == VALLEY;
        nearest -= (wall ? WALL : LEAN) * grain.x * off;
        float floor_there = place.z + dot(slopes.xy, aside) - 0.1 * length(slopes.xy) - hair;
        if (kind == RING) nearest = min(nearest, floor_there);
        shown = finished(gl_FragCoord.xy) >= nearest;
    }
    if (shown) shown = seen(on);
    if (!shown) drawn *= crowded || hidden_share > 0.0 && is_none(on) ? 0.0 : hidden_at(t);
    if (drawn.a <= 0.0) discard;
    colour = cover * drawn;
}
