// What:   an edge on the screen as a stroke of the paper: its ends, sides, normals and texture.
// Inputs: an edge (edges.glsl); the look of each kind: contours, ridges, valleys, marked, boundary.
// Source: McGuire & Hughes 2004, sections 3.2, 3.3 and 4. Numpy reference:
//         glshim/geometry/references/thick_lines.py. Pixels are from the middle of the viewport.

uniform int wanted;         // bits of features
uniform int shown;          // bits of those that are drawn now
uniform vec2 turns;         // cosines of the threshold angles of ridges and valleys
uniform float inks[15];     // red, green, blue of each kind
uniform float reaches[5];   // pixels from an edge to the side of its stroke
uniform float lengths[5];   // pixels after which a texture or a dash repeats
uniform int halves;         // bits of the kinds that are half quads
uniform int along;          // texture coordinates in OBJECT or SCREEN space, or DASHES
uniform int capped;         // 1: caps are drawn, too

flat out vec3 ink;
noperspective out vec2 grain;   // texture coordinates; across from 0 outside to 1 inside
noperspective out vec2 middle;  // the place on the edge itself: pixels of the window

const float INSIDE = 1.0 - 1e-5;
const int OBJECT = 0, SCREEN = 1, DASHES = 2;

struct Stroke {
    int kind;       // the first of its features that is wanted; none, or it is not shown: 5
    vec2 s0, s1;    // pixels
    vec2 p;         // the unit perpendicular
    vec2 m0, m1;    // unit normals
    float z0, z1;   // depths in clip space
    float side0, side1;
    float reach, u0, u1;
    bool half_quad;
};

float side(vec2 m, vec2 p) { return dot(m, p) < 0.0 ? -1.0 : 1.0; }

// The part of a line in clip space between the near and the far plane; whether there is one.
bool cut(inout vec4 a, inout vec4 b) {
    for (int k = 0; k < 2; ++k) {
        float way = k == 0 ? 1.0 : -1.0;
        float at_a = INSIDE * a.w + way * a.z, at_b = INSIDE * b.w + way * b.z;
        if (at_a <= 0.0 && at_b <= 0.0) return false;
        vec4 met = a + at_a / (at_a - at_b) * (b - a);
        if (at_a <= 0.0) a = met;
        if (at_b <= 0.0) b = met;
    }
    return a.w > 0.0 && b.w > 0.0;
}

Stroke this_stroke() {
    Stroke s;
    s.kind = 5;
    Edge e = this_edge();
    int found = features(e, turns) & wanted;
    if (found == 0) return s;
    vec4 a = clip(e.p0), b = clip(e.p1);
    if (!cut(a, b)) return s;
    for (int k = 4; k >= 0; --k) if ((found >> k & 1) == 1) s.kind = k;
    if ((shown >> s.kind & 1) == 0) {
        s.kind = 5;
        return s;
    }
    s.s0 = pixels(a);
    s.s1 = pixels(b);
    s.z0 = a.z / a.w;
    s.z1 = b.z / b.w;
    vec2 way = s.s1 - s.s0;
    s.p = unit(vec2(-way.y, way.x));
    s.m0 = projected(normal(e.v0), a);
    s.m1 = projected(normal(e.v1), b);
    // Where a surface has two sides its normals may point to either: away from its own image then.
    vec4 within = clip(e.p2);
    if (e.open && (found & CONTOUR_EDGE) != 0 && within.w > 0.0) {
        float inner = dot(pixels(within) - s.s0, s.p);
        if (dot(s.m0, s.p) * inner > 0.0) s.m0 = -s.m0;
        if (dot(s.m1, s.p) * inner > 0.0) s.m1 = -s.m1;
    }
    s.side0 = side(s.m0, s.p);
    s.side1 = side(s.m1, s.p);
    s.reach = reaches[s.kind];
    s.half_quad = (halves >> s.kind & 1) == 1;
    float w = s.side0 / lengths[s.kind];
    float repeats = length(way) / lengths[s.kind];
    if (along == DASHES && repeats >= 2.0) {  // a dash at each end, all of a length
        s.u0 = 0.5;
        s.u1 = 0.5 + floor(repeats + 0.5);
    } else if (along != OBJECT) {  // tessellated lines are dashed as if they were not

        vec4 origin = clip(vec3(0.0));
        vec2 c = origin.w > 0.0 ? pixels(origin) : vec2(0.0);
        bool upright = abs(way.y) > abs(way.x);
        s.u0 = w * (upright ? s.s0.y - c.y : s.s0.x - c.x);
        s.u1 = w * (upright ? s.s1.y - c.y : s.s1.x - c.x);
    } else {
        s.u0 = e.r;
        s.u1 = e.r + w * length(way);
    }
    ink = vec3(inks[3 * s.kind], inks[3 * s.kind + 1], inks[3 * s.kind + 2]);
    return s;
}

// Whether a cap winds counter-clockwise, which with the rule of j is where m leans beyond its end.
bool start_fills(Stroke s) { return s.p.x * s.m0.y - s.p.y * s.m0.x > 0.0; }
bool finish_fills(Stroke s) { return s.p.x * s.m1.y - s.p.y * s.m1.x < 0.0; }

// A corner of the stroke; on: the place on the edge's line that it belongs to. The depth is that of
// an end, the same across the stroke, which lies in the plane of the screen.
void put(Stroke s, vec2 place, vec2 on, bool at_finish, vec2 texture_at) {
    gl_Position = vec4(place / viewport.zw, at_finish ? s.z1 : s.z0, 1.0);
    middle = on + viewport.xy;
    grain = texture_at;
}
