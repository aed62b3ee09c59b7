// What:   a stroke, as the vertex shader makes it, and whether its line is seen at a place along
//         it: the layer's finished depth is asked beside it.
// Inputs: finished depth (depth.glsl). For both stages, GLSL 1.20 too.
// Source: Raskar 2001, sections 2.1 to 2.4; the between-test is in `seen_alone`.

PASSED vec3 line_a;   // pixels of the framebuffer, depth (greater is farther)
PASSED vec3 line_b;
PASSED vec2 onwards;  // direction of the next side at an outer corner of an outline; else 0
PASSED vec4 slopes;   // depth a pixel on the line's plane and on the other polygon's
PASSED vec3 extent;   // pixels outwards between which the ink lies; kind and group
PASSED vec2 repeats;  // of a pattern at a and at b; the same where there is none
PASSED vec2 grain;    // depth of a pixel at 45 degrees; depth that counts as seen

const int GROUPS = 8, MARKED = 4, BOUNDARY = 5, SUGGESTIVE = 6;  // of lines: glshim/model/lines.py
const int SHARED = 8 * 16;  // added to kinds of lines that lie on other objects
uniform float hidden_share;  // ink of what is hidden, of one
uniform vec2 ridge_turn;     // cosine and sine of the threshold angle of ridges

const float MEETING = 0.05;  // pixels' worth of depth by which surfaces that meet may miss
const float PLANE = 0.03;    // radians by which faces side by side in one plane may bend
const float CURVE = 0.2;     // the same where an open side runs on another surface
const float SHEER = 6.0;     // the same, of a pixel of a steep surface
const float TORN = 1.5;      // pixels' worth of depth by which facets of bodies that meet may miss

vec2 along, out_1;
float span;
int kind, group;
bool shared_edge;  // with another body
bool crowded;      // among many: not drawn where it is hidden

// Fills the variables above from the stroke.
void take_stroke() {
    along = line_b.xy - line_a.xy;
    span = length(along);
    along /= span;
    out_1 = vec2(along.y, -along.x);
    kind = int(extent.z + 0.5);
    int extra = kind / 16;
    kind -= 16 * extra;
    crowded = extra > 15;
    extra -= crowded ? 16 : 0;
    shared_edge = extra > 7;
    extra -= shared_edge ? 8 : 0;
    group = extra > 0 ? extra + 3 : (kind > 2 ? kind - 2 : 0) / 2;
}

// Depth by which what is beside a line of a kind may be nearer than it. deep: of a pixel at 45
// degrees; drop: that the line gains in a pixel.
float slack_of(int kind, float deep, float drop) {
    if (kind == CONTOUR) return -0.25 * deep;
    if (kind == HOLLOW) return -2.0 * deep;
    return kind == FIN || kind == LONE_RIDGE || kind == LONE_VALLEY ? 0.0 : min(drop, deep);
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

// Whether what is drawn in the pixel beside a place is no nearer than the side.
bool clear_beside(vec3 place) {
    vec2 centre = beyond(place.xy, out_1);
    return finished(centre) - place.z >= level(centre - place.xy) - grain.y;
}

// What an edge shows in the pixel beside a place. 3: the polygon that lies there. 2: something that
// is no nearer than the edge. 1: something a little nearer: the next polygon. 0: something before
// it.
int shown_beside(vec3 place, vec2 outwards) {
    vec2 centre = beyond(place.xy, outwards), off = centre - place.xy;
    float depth = finished(centre) - place.z;
    vec2 slope = dot(off, out_1) < 0.0 ? slopes.xy : slopes.zw;
    if (abs(depth - surface(off)) <= grain.y + 0.25 * grain.x + 0.005 * length(slope)) return 3;
    float before = level(off) - grain.y - depth;
    return before <= 0.0 ? 2 : before < 1.5 * grain.x ? 1 : 0;
}

// What is drawn beside a place, carried on to it over a square of four pixels: its depth over the
// side's. Whether the four lie in one plane at all. near: depth of the first pixel, over the
// side's. margin: what counts as on the side.
bool carried_on(vec3 place, out float near, out float gap, out float margin) {
    vec2 one = beyond(place.xy, out_1), off = place.xy - one;
    vec2 right = vec2(out_1.x < 0.0 ? -1.0 : 1.0, 0.0), up = vec2(0.0, out_1.y < 0.0 ? -1.0 : 1.0);
    float depth = finished(one);
    float along_x = finished(one + right) - depth, along_y = finished(one + up) - depth;
    vec2 slope = along_x * right + along_y * up;
    near = depth - place.z - level(-off);
    gap = depth - place.z + dot(slope, off);
    margin = (MEETING + blur) * max(grain.x, length(slope)) + hair;
    return abs(finished(one + right + up) - depth - along_x - along_y) < margin;
}

// A contour over a surface that rises towards the viewer from behind it: a wall, or the floor that
// a box stands on. before: depth by which it must stand out.
bool stands_out(vec3 place, float before) {
    float near, gap, margin;
    return carried_on(place, near, gap, margin) && gap >= before - (kind == RING ? margin : 0.0);
}

// Sides that know no neighbour. What is drawn beside one may meet it: a neighbour after all.
// Section 2.2: the quad of a ridge is before it. Section 2.3: the quad of a valley is trapped
// behind it.
bool seen_alone(vec3 place) {
    float near, gap, margin;
    bool one_surface = carried_on(place, near, gap, margin);
    if (kind == FIN) return one_surface ? gap > margin : near >= -hair - blur * grain.x;
    vec2 off = beyond(place.xy, out_1) - place.xy;
    float quad = dot(slopes.xy, off) - level(off) - grain.y;
    return one_surface && abs(gap) < margin && (kind == LONE_RIDGE ? quad <= near : quad > near);
}

// What is drawn on one side of a place: its depth there, over the side's, and how that grows in a
// pixel outwards.
vec2 towards_line(vec3 place, vec2 outwards) {
    vec2 one = beyond(place.xy, outwards), two = beyond(place.xy + 2.0 * outwards, outwards);
    float s = dot(one - place.xy, out_1), rise = finished(one) - place.z - level(one - place.xy);
    float slope = finished(two) - place.z - level(two - place.xy) - rise;
    slope /= dot(two - one, out_1);
    return vec2(rise - slope * s, slope);
}

// By how much the two sides of what is seen across the line miss each other there, in pixels' worth
// of depth; 0.0 where they meet, more than TORN where they are no surface that goes on. off: the
// same of the line.
float torn_at(vec3 place, out float off) {
    vec2 right = towards_line(place, out_1), left = towards_line(place, -out_1);
    float steep = max(abs(left.y), abs(right.y)), scale = clamp(steep, grain.x, SHEER * grain.x);
    off = right.x / scale;
    float most = kind == FIN || group == BOUNDARY ? CURVE : PLANE;
    if (abs(atan(right.y, grain.x) - atan(left.y, grain.x)) > most) return 2.0 * TORN;
    float gap = right.x - left.x, margin = (MEETING + blur) * max(grain.x, steep) + hair;
    return abs(gap) < margin ? 0.0 : gap / scale;
}

float inner(float t) { return clamp(t, min(8.0, 0.5 * span), max(span - 8.0, 0.5 * span)); }

// Whether what is seen is one surface across the line at t, whatever polygons and bodies it is of:
// faces side by side in one plane, a sphere that ends a cylinder. An open side that only comes near
// another surface is not in it all along; one that lies a hair before a wall does so all along; and
// faces that overlap in one plane have no common edge. Where two bodies meet in a curve, their
// facets come forward in turns. Near its ends, where others cross it, a line is what it is farther
// in.
bool flush_at(float t, out float off) {
    if (shared_edge) t = inner(t);
    off = 0.0;
    bool open = kind == FIN || kind == LONE_RIDGE || kind == LONE_VALLEY || group == BOUNDARY;
    if (!open && !shared_edge) return false;
    if (group == MARKED || group == SUGGESTIVE || ridge_turn.x < -0.98) return false;
    float gap = torn_at(point(t), off), other;
    if (abs(off) > TORN) return false;  // what is seen lies behind the line
    if (kind != FIN && group != BOUNDARY) return gap == 0.0;
    if (abs(gap) > TORN) return false;
    bool turns = gap == 0.0;
    int near = 0;
    for (float part = 0.1; part < 1.0; part += 0.2) {
        float there = torn_at(point(part * span), other);
        near += abs(there) > TORN ? 0 : 1;
        turns = turns || there * gap <= 0.0;
    }
    return turns && near > 2;
}

bool drawn_at_line(float t) {
    vec3 place = point(t);
    if (kind == FIN || kind == LONE_RIDGE || kind == LONE_VALLEY) return seen_alone(place);
    if (kind > FIN) {  // one of its polygons is enough, or nothing before it
        int right = shown_beside(place, out_1);
        return right == 3 || right + shown_beside(place, -out_1) >= 3;
    }
    bool here = clear_beside(place);
    if (kind == RING) return here || stands_out(place, 0.0);
    // Two pixels beside a smooth contour: flaps of the mesh stand out less.
    return here && clear_beside(place + vec3(out_1, 0.0)) || stands_out(place, -grain.y);
}

bool seen_at(float t) {
    float off;
    return drawn_at_line(shared_edge ? inner(t) : t) && !flush_at(t, off);
}

// Most of five places along the line: no dots, no holes of two pixels. A loop, since drivers in
// software leave loops early but walk through every branch.
bool seen(float t) {
    float balance = 0.0, aside = 0.0;
    for (int i = 0; i < 5; ++i) {
        balance += seen_at(t + aside) ? 1.0 : -1.0;
        if (abs(balance) > float(4 - i)) break;
        aside = aside < 0.0 ? -aside : -aside - 1.0;
    }
    return balance > 0.0;
}

// Whether a line is not seen because there is none, not even a hidden one: it lies in one surface.
bool is_none(float t) {
    float off;
    return flush_at(t, off);
}
