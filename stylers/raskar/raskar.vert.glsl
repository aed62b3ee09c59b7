// What:   one strip a line. Ring: the part of a polygon's enlargement beyond one side, with the
//         corner to the next side. Ridge: the quad at the threshold angle, with the wedge to the
//         next quad. Fin: the outline of an open side.
// Inputs: a line record and the camera (line.glsl); widths in pixels; the threshold angle.
//         Six vertices: a out, a, b out, b, tip of the corner, next side's b out.
// Source: Raskar 2001, sections 2.1 and 2.2, stepped straight out on the screen so that the width
//         is exact (derivation and numpy reference: glshim/geometry/raskar.py).

uniform float silhouette_width; // outside the polygon
uniform float ridge_width;      // of one quad, half of the visible line
uniform vec2 ridge_turn;        // cosine and sine of the threshold angle

noperspective out vec3 spine;   // where the line's visibility is decided: pixels, window depth
flat out vec2 spine_slope;      // window depth a pixel on the line's plane
flat out vec2 spine_out;        // outwards from the side, unit
flat out float spine_free;      // widths about the corner within which depth alone decides
flat out int spine_places;      // places to ask at, one seen is enough; 0: depth alone decides
flat out float spine_slack;     // window depth by which the spine may lie behind what is drawn
noperspective out vec2 reach;   // place along and across the line in widths; ink ends at length 1

const float INSET = 1.0 / 128.0; // pixels by which a ring reaches under its object, for no cracks
const float SNAP = 1.0 / 256.0;  // pixels, against what rasterisation rounds away
const float EDGE_ON = 0.02;     // ridge quads flatter to the line of sight cannot be seen
const float FIN_TILT = 0.17;    // cosine between a fin and the line of sight
const float LONGEST_TIP = 3.0;  // widths
const float STEEP = 0.2;       // cosine to the line of sight of the flattest plane a ring follows
const float LIFT = 0.5;         // pixels' worth of depth by which a line wins over its plane
const float LEAN = 1.0;         // pixels by which a line that is seen comes nearer in each pixel

// Depth (ndc, + is away) against a side's own at a place whose depth on the line's plane is deeper
// and on the plane that leans towards the viewer nearer; lift: LIFT pixels' worth of depth.
float biased(int kind, float deeper, float nearer, float lift, bool follows) {
    float grain = abs(hair);
    if (kind == RIDGE) return min(deeper, 0.0) - lift - grain;
    if (kind == LONE_RIDGE) return deeper + grain;
    if (follows) return deeper - lift - grain;
    return (nearer < 0.0 ? nearer : max(deeper, 0.0)) + 2.0 * grain;
}

// Normal of the plane that the line beside a side lies in. Eye space, all unit; sight is the
// direction from the side to the viewer.
vec3 line_plane(int kind, vec3 along, vec3 normal, vec3 sight) {
    vec3 outward = normalize(cross(along, normal));
    vec3 upright = cross(outward, along);
    if (kind == RING) return upright;
    if (kind == FIN) {
        vec3 level = normalize(cross(along, sight));
        level *= dot(level, outward) < 0.0 ? -1.0 : 1.0;
        vec3 seen = normalize(sight - dot(sight, along) * along);
        return FIN_TILT * seen + sqrt(1.0 - FIN_TILT * FIN_TILT) * level;
    }
    upright *= dot(upright, sight) < 0.0 ? -1.0 : 1.0;
    return ridge_turn.y * outward - ridge_turn.x * upright;
}

void main() {
    gl_Position = NOWHERE;
    reach = vec2(0.0);
    spine = vec3(0.0);
    spine_slope = spine_out = vec2(0.0);
    spine_slack = spine_free = 0.0;
    spine_places = 0;
    int kind = int(edge_kind.x);
    bool ridge = kind == RIDGE || kind == LONE_RIDGE;
    float width = ridge ? ridge_width : silhouette_width;

    vec4 eye_a = modelview * vec4(edge_a, 1.0);
    vec4 eye_b = modelview * vec4(edge_b, 1.0);
    vec4 far_a = projection * eye_a, far_b = projection * eye_b;
    float cut_a = near_cut(far_a, far_b), cut_b = near_cut(far_b, far_a);
    vec4 clip_a = mix(far_a, far_b, cut_a), clip_b = mix(far_b, far_a, cut_b);
    if (far_a.z < -far_a.w && far_b.z < -far_b.w) return;
    if (min(clip_a.w, clip_b.w) <= 0.0) return;
    vec2 pixel_a = pixels(clip_a), pixel_b = pixels(clip_b), along = pixel_b - pixel_a;
    if (dot(along, along) < 1e-6) return;
    along = normalize(along);

    vec3 normal = normalize(normal_matrix * edge_plane.xyz);
    vec3 sight = normalize(viewpoint.xyz - viewpoint.w * eye_a.xyz);
    vec3 plane = line_plane(kind, normalize(eye_b.xyz - eye_a.xyz), normal, sight);
    float side = edge_kind.y, turned = dot(plane, sight);
    if (ridge) {
        if (abs(turned) < EDGE_ON) return;
        if (turned < 0.0 && ridge_turn.y >= 0.0) return;  // hidden behind its own polygon
        side *= sign(turned);
    }
    vec2 out_1 = side * vec2(along.y, -along.x), offset;
    vec2 slope = depth_slope(plane, eye_a.xyz), slope_1 = slope, slope_2 = slope;
    float reached = width + SNAP;

    int corner = gl_VertexID;
    bool under = corner == 1 || corner == 3;
    if (corner < 4) {
        offset = under ? (kind == RING ? -INSET : 0.0) * out_1 : reached * out_1;
        reach = vec2(0.0, dot(offset, out_1) / reached);
    } else if (far_b.z < -far_b.w) {
        offset = vec2(0.0);  // cut by the near plane: no corner
    } else {
        vec4 eye_c = modelview * vec4(edge_c, 1.0);
        vec4 clip_c = projection * eye_c;
        clip_c = mix(clip_c, far_b, near_cut(clip_c, far_b));
        vec2 along_2 = pixels(clip_c) - pixel_b;
        if (clip_c.w <= 0.0 || dot(along_2, along_2) < 1e-6) along_2 = along;
        along_2 = normalize(along_2);
        vec2 out_2 = side * vec2(along_2.y, -along_2.x);
        if (side * (along.x * along_2.y - along.y * along_2.x) <= 0.0)
            out_2 = ridge ? out_1 : along;    // no corner of its own: an end round half the way
        if (kind != RING) {
            vec3 sight_2 = normalize(viewpoint.xyz - viewpoint.w * eye_b.xyz);
            vec3 plane_2 = line_plane(kind, normalize(eye_c.xyz - eye_b.xyz), normal, sight_2);
            if (ridge && dot(plane_2, sight_2) * turned < EDGE_ON * abs(turned)) out_2 = out_1;
            else slope_2 = depth_slope(plane_2, eye_b.xyz);
        }
        vec2 middle = 0.5 * (out_1 + out_2);
        float halved = length(middle);        // cosine of half the turn
        if (corner == 5) offset = reached * out_2;
        else if (halved > 1e-3) offset = reached * min(1.0 / halved, LONGEST_TIP) * middle / halved;
        else offset = reached * LONGEST_TIP * along;
        reach = vec2(dot(offset, along), dot(offset, out_1)) / reached;
        slope = corner == 5 ? slope_2 : 0.5 * (slope + slope_2);
    }
    vec4 clip = corner < 2 ? clip_a : clip_b;
    float away = sign(hair), steep = length(slope_1), flatness = min(1.0, abs(turned) / STEEP);
    float lift = LIFT * steep * flatness;
    float pixel_deep = steep * abs(turned) / max(sqrt(max(1.0 - turned * turned, 0.0)), 0.05);
    bool follows = kind == RING && spines && abs(turned) > STEEP;
    float nearer = spines && corner < 4 ? -LEAN * pixel_deep * dot(offset, out_1) : 0.0;
    float depth = away * biased(kind, away * dot(slope, offset), nearer, lift, follows);
    clip_as_the_app(corner < 2 ? mix(eye_a, eye_b, cut_a) : mix(eye_b, eye_a, cut_b));
    vec2 place = clip.xy + offset / half_viewport * clip.w;
    gl_Position = vec4(place, clamp(clip.z + depth * clip.w, -clip.w, clip.w), clip.w);

    if (spines && kind != LONE_RIDGE && !(kind == RIDGE && ridge_turn.y < 0.0)) {
        spine_slope = slope_1;
        if (kind == RING && !follows) {  // level across
            float length_ab = max(length(pixel_b - pixel_a), 1e-3);
            spine_slope = (clip_b.z / clip_b.w - clip_a.z / clip_a.w) / length_ab * along;
        }
        float window = 0.5 * (range.y - range.x);
        spine.xy = pixels(clip) + half_viewport;
        spine.z = clip.z / clip.w * window + 0.5 * (range.x + range.y);
        spine_slope *= window;
        spine_out = out_1;
        spine_places = kind == FIN || (kind == RING && !follows) ? 2 : 1;
        spine_free = kind == RING && corner > 3 ? 1.5 / reached : 0.0;
        spine_slack = kind == RIDGE ? pixel_deep : 0.25 * lift;
        spine_slack = abs(window) * (kind == FIN ? -0.5 * pixel_deep : spine_slack + abs(hair));
    }
}
