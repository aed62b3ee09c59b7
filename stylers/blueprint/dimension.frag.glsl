// What:   a dimension: two thin lines out from the ends of an edge, one between them with
//         arrowheads, and the edge's length.
// Inputs: dimension.glsl; characters 0 to 9 and the point, side by side.
// Source: NPRQuake's blueprint; drawn as drawings have it (ISO 129).

uniform vec3 rule;
uniform float opacity;
uniform sampler2D stroke;

const float POINT = 10.0;
const float CHARACTERS = 11.0;
#define ARROW (9.0 * shot.z)

float near(float off, float half_width) { return clamp(half_width + 0.5 - abs(off), 0.0, 1.0); }

// The character at a place of the number: 0 to 9, or the point.
float character(float at, float after) {
    float before = dimension.y - (after > 0.0 ? after + 1.0 : 0.0);
    if (at == before && after > 0.0) return POINT;
    float from_right = at < before ? before - 1.0 - at + after : dimension.y - 1.0 - at;
    float whole = floor(dimension.x * pow(10.0, after) + 0.5);
    return mod(floor(whole / pow(10.0, from_right) + 1e-4), 10.0);
}

void main() {
    take_stroke();
    vec2 from_a = gl_FragCoord.xy - line_a.xy;
    float t = dot(from_a, along), s = dot(from_a, out_1);
    float reach = near(s - 0.5 * OFF - 4.0 * shot.z, 0.5 * OFF);
    float ink = reach * max(near(t, 0.35 * shot.z), near(t - span, 0.35 * shot.z));
    float inside = near(t - 0.5 * span, 0.5 * span);
    ink = max(ink, inside * near(s - OFF, 0.35 * shot.z));
    float from_end = min(t, span - t);
    ink = max(ink, inside * near(s - OFF, 0.3 * from_end) * step(from_end, ARROW));

    // Read from below or from the right, whichever way the line runs.
    bool turned = along.x < -0.01 || (abs(along.x) <= 0.01 && along.y < 0.0);
    vec2 reading = turned ? -along : along, up = vec2(-reading.y, reading.x);
    vec2 middle = line_a.xy + 0.5 * span * along + (OFF + 3.0 * shot.z + 0.5 * HIGH) * out_1;
    vec2 place = gl_FragCoord.xy - middle;
    float column = dot(place, reading) / WIDE + 0.5 * dimension.y;
    float row = dot(place, up) / HIGH + 0.5;
    if (row > 0.0 && row < 1.0 && column >= 0.0 && column < dimension.y) {
        float sign = character(floor(column), decimals(dimension.x));
        ink = max(ink, textureLod(stroke, vec2((sign + fract(column)) / CHARACTERS, row), 0.0).a);
    }
    if (ink * opacity <= 0.004) discard;
    colour = vec4(rule, 1.0) * ink * opacity;
}
