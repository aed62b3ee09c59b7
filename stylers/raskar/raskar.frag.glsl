// What:   ink on the pixels of one stroke, as much as it covers, where its line is seen.
// Inputs: the stroke from raskar.vert.glsl; ink; a texture along and across the stroke. GLSL 1.20
//         and later.
// Source: Raskar 2001, sections 2.1 to 2.4; the between-test is `lies_between`.

FROM_VERTEX vec3 line_a;
FROM_VERTEX vec3 line_b;
FROM_VERTEX vec2 onwards;
FROM_VERTEX vec4 slopes;
FROM_VERTEX vec4 extent;
FROM_VERTEX vec2 grain;

uniform vec3 ink;
uniform sampler2D stroke;     // alpha: ink; colour: multiplies ink
uniform vec2 stroke_size;     // pixels along after which it repeats, or 0 for none; width at v = 1

const float LEAN = 1.0;       // pixels' worth of depth by which a line comes nearer in each pixel
const float STEEPEST = 10.0;  // the same over what hides the quad of a lone valley
const float TRAP = 0.5;       // pixels' worth of depth: half of z2 less z1 of the between-test
const int RING = 0, CONTOUR = 1, HOLLOW = 2, FIN = 3, RIDGE = 4, LONE_RIDGE = 5, LONE_VALLEY = 7;

vec2 along, out_1;
float span;
int kind;

// The point of the line t pixels from a: pixels, depth.
vec3 point(float t) { return line_a + t / span * (line_b - line_a); }

// Depth of the line's surface over the side's own at a place off it: on the farther one of the two
// polygons of a ridge, on the nearer one else;
// never behind the side for an outline.
float surface(vec2 off) {
    float level = (line_b.z - line_a.z) / span * dot(off, along);
    float own = dot(slopes.xy, off), other = dot(slopes.zw, off);
    if (kind == CONTOUR || kind == HOLLOW) return level;
    if (kind == RING) return min(own, level);
    return kind == RIDGE ? max(own, other) : min(own, other);
}

// Whether the surface beside a place of the line is what is drawn there.
bool seen_beside(vec3 place, vec2 outwards) {
    vec2 centre = beyond(place.xy, outwards);
    return place.z + surface(centre - place.xy) - grain.y <= finished(centre);
}

// Section 2.3: the quad lies behind what is drawn beside the line, and that surface, carried on to
// the line over two pixels, meets it (z1 and z2 are a pixel apart there).
bool lies_between(vec3 place) {
    vec2 one = beyond(place.xy, out_1), two = beyond(place.xy + 1.5 * out_1, out_1);
    vec2 off = one - place.xy, step = two - one;
    float near = finished(one), slope = (finished(two) - near) / dot(step, out_1);
    if (near >= place.z + dot(slopes.xy, off) - grain.y) return false;
    float level = (line_b.z - line_a.z) / span * dot(off, along);
    float gap = near - slope * dot(off, out_1) - place.z - level;
    return abs(gap) < TRAP * max(grain.x, abs(slope)) + grain.y;
}

bool seen_at(float t) {
    vec3 place = point(t);
    if (kind == LONE_VALLEY) return lies_between(place);
    bool here = seen_beside(place, out_1);
    if (kind <= FIN) {
        // Two pixels beside a smooth contour: flaps of the mesh stand out less. One beside others.
        if (here != (kind == CONTOUR || kind == HOLLOW)) return here;
        return seen_beside(place + vec3(out_1, surface(out_1)), out_1);
    }
    return here || (kind != LONE_RIDGE && seen_beside(place, -out_1));
}

// Two of three places along the line: no dots, no holes of a pixel.
bool seen(float t) {
    bool here = seen_at(t), before = seen_at(t - 1.0);
    return here == before ? here : seen_at(t + 1.0);
}

// Share of a pixel off the line by s outwards, by past beyond its ends, that the stroke covers.
float covered(float s, float past, vec2 from_b) {
    float rim = clamp(extent.y + 0.5 - length(vec2(past, s)), 0.0, 1.0);
    if (extent.x == -extent.y) return rim;
    if (past == 0.0) return rim * clamp(s - extent.x + 0.5, 0.0, 1.0);
    return past > 0.0 && dot(from_b, onwards) < 0.0 ? rim : 0.0;
}

void main() {
    vec2 from_a = gl_FragCoord.xy - line_a.xy;
    along = line_b.xy - line_a.xy;
    span = length(along);
    along /= span;
    out_1 = vec2(along.y, -along.x);
    kind = int(extent.z + 0.5);
    float t = dot(from_a, along), s = dot(from_a, out_1), on = clamp(t, 0.0, span);
    float cover = covered(s, t - on, gl_FragCoord.xy - line_b.xy);
    if (cover <= 0.0) discard;

    float off = length(vec2(t - on, s));
    if (off > 0.75) {  // nearer, the line itself decides
        vec3 place = point(on);
        float level = (line_b.z - line_a.z) / span * (t - on);
        float depth = place.z + min(surface(gl_FragCoord.xy - place.xy), level);
        float lean = kind == LONE_VALLEY ? STEEPEST : LEAN;
        if (depth - grain.y - lean * grain.x * off > finished(gl_FragCoord.xy)) discard;
    }
    if (!seen(on)) discard;
    vec4 drawn = vec4(ink, 1.0);
    if (stroke_size.x > 0.0) {
        float v = (s - extent.x) / (extent.y - extent.x);
        drawn *= texture(stroke, vec2((extent.w + t) / stroke_size.x, v));
    }
    float alpha = cover * drawn.a;
    colour = vec4(drawn.rgb * alpha, alpha);
}
