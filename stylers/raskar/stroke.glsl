// What:   a stroke, as the vertex shader makes it, and whether its line is seen at a place along it:
//         the layer's finished depth is asked beside it.
// Inputs: finished depth (depth.glsl). For both stages, GLSL 1.20 too.
// Source: Raskar 2001, sections 2.1 to 2.4; the between-test is `lies_between`.

PASSED vec3 line_a;   // pixels of the framebuffer, depth (greater is farther)
PASSED vec3 line_b;
PASSED vec2 onwards;  // direction of the next side at an outer corner of an outline; else 0
PASSED vec4 slopes;   // depth a pixel on the line's plane and on the other polygon's
PASSED vec3 extent;   // pixels outwards between which the ink lies; kind
PASSED vec2 repeats;  // of a pattern at a and at b; the same where there is none
PASSED vec2 grain;    // depth of a pixel at 45 degrees; depth that counts as seen

const float MEETING = 0.1;  // pixels' worth of depth by which surfaces that meet may miss

vec2 along, out_1;
float span;
int kind;

// Fills the variables above from the stroke.
void take_stroke() {
    along = line_b.xy - line_a.xy;
    span = length(along);
    along /= span;
    out_1 = vec2(along.y, -along.x);
    kind = int(extent.z + 0.5);
}

// The point of the line t pixels from a: pixels, depth.
vec3 point(float t) { return line_a + t / span * (line_b - line_a); }

// What the depth of the side would be at a place off it, over that of its nearest point.
float level(vec2 off) { return (line_b.z - line_a.z) / span * dot(off, along); }

// Depth of the line's surface over the side's own at a place off it: as deep as the side for what
// occludes; on the polygon that lies there, for an edge; on the nearer one at an intersection.
float surface(vec2 off) {
    if (kind <= FIN) return level(off);
    float own = dot(slopes.xy, off), other = dot(slopes.zw, off);
    if (kind == INTERSECTION) return min(own, other);
    return dot(off, out_1) < 0.0 ? own : other;
}

// Whether the surface beside a place of the line is what is drawn there: nothing is before it, and
// where it rises towards the viewer it is not behind it either.
bool seen_beside(vec3 place, vec2 outwards) {
    vec2 centre = beyond(place.xy, outwards), off = centre - place.xy;
    float depth = finished(centre), expected = place.z + surface(off);
    bool hollow = kind > FIN && kind != LONE_RIDGE && dot(slopes.zw - slopes.xy, out_1) < 0.0;
    if (!hollow) return expected - grain.y <= depth;
    return abs(expected - depth) <= grain.y + 0.1 * max(length(slopes.xy), length(slopes.zw));
}

// Whether what is drawn at a place off the side lies in the plane of the polygon that turns away:
// the floor that a box stands on.
bool on_the_floor(vec3 place, vec2 off, float depth) {
    if (kind != RING) return false;
    float slack = hair + (0.03 + blur) * length(slopes.xy);
    return abs(place.z + dot(slopes.xy, off) - depth) <= slack;
}

// Whether two pixels beside a place show the floor.
bool stands(vec3 place) {
    vec2 one = beyond(place.xy, out_1), two = beyond(place.xy + out_1, out_1);
    return on_the_floor(place, one - place.xy, finished(one))
        && on_the_floor(place, two - place.xy, finished(two));
}

// Sides that know no neighbour. What is drawn beside one, at two pixels, is carried on to the side:
// where it meets it, it is a neighbour after all. Section 2.2: the quad of a ridge is before it.
// Section 2.3: the quad of a valley is trapped just behind it.
bool seen_alone(vec3 place) {
    vec2 one = beyond(place.xy, out_1) - place.xy;
    vec2 two = beyond(place.xy + 2.0 * out_1, out_1) - place.xy;
    float near = finished(place.xy + one) - level(one), far = finished(place.xy + two) - level(two);
    float slope = (far - near) / dot(two - one, out_1);
    float gap = near - slope * dot(one, out_1) - place.z;
    bool meets = abs(gap) < (MEETING + blur) * max(grain.x, abs(slope)) + hair;
    if (kind == FIN) return !meets && place.z - hair - blur * grain.x <= near;
    float quad = place.z + dot(slopes.xy, one) - level(one);
    return meets && (kind == LONE_RIDGE ? quad - grain.y <= near : quad - grain.y > near);
}

bool seen_at(float t) {
    vec3 place = point(t);
    if (kind == FIN || kind == LONE_RIDGE || kind == LONE_VALLEY) return seen_alone(place);
    bool here = seen_beside(place, out_1);
    if (kind == RING) return here || stands(place);
    if (kind > FIN) return here || seen_beside(place, -out_1);
    // Two pixels beside a smooth contour: flaps of the mesh stand out less.
    return here && seen_beside(place + vec3(out_1, 0.0), out_1);
}

// Two of three places along the line: no dots, no holes of a pixel.
bool seen(float t) {
    bool here = seen_at(t), before = seen_at(t - 1.0);
    return here == before ? here : seen_at(t + 1.0);
}
