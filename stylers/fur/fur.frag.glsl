// What:   the hairs that pass through a place of a shell or a fin, in the app's colours.
// Inputs: hair.glsl's; the app's picture and its finished depth (depth.glsl).
// Source: Lengyel et al. 2001, section 3.2 (a hair is the same texel of all shells); Kajiya & Kay
//         1989; cells of hashed hairs stand in for the texture, as an app's mesh has no parameters.

in vec3 root;
in float height, fade;
in vec4 ground;
in vec2 nearest, inward;
in vec3 lit;
in vec3 upright;

uniform sampler2D app_colour;
uniform vec4 viewport;
uniform vec2 range;
uniform vec4 fur_colour;  // alpha 0: the app's
uniform float thickness;  // radius of a hair at its root, in cells
uniform float curl;
uniform float sheen;

const float SKIN = 0.02;  // height of the innermost shell: closed

// Four numbers in 0..1 that belong to a cell (Jarzynski & Olano 2020, pcg3d).
vec4 random_of(ivec3 at) {
    uvec3 v = uvec3(at) * 1664525u + 1013904223u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    return vec4(v >> 8u, (v.x ^ v.y) >> 8u) / 16777216.0;
}

float depth_of(vec2 zw) {
    return mix(range.x, range.y, 0.5 * zw.x / zw.y + 0.5);
}

// The app's colour where a hair grows, alpha 0 where it is not to be had.
vec4 grown_from() {
    vec2 foot = viewport.xy + ground.xy / ground.w * viewport.zw;
    float depth = depth_of(ground.zw), before = nearest.y > 0.0 ? depth_of(nearest) : -2.0;
    float near = 0.04 * (depth - before) + 2.0 * hair;
    vec2 place = foot;
    bool found = lit.z < 0.1 && abs(finished(foot) - depth) < near;
    if (!found) {
        place = gl_FragCoord.xy;
        found = lit.z < 0.0 && abs(finished(place) - depth) < 3.0 * near;
    }
    // Over the rim: what of the object is seen before it; failing that, what hides the object.
    bool hidden = false;
    vec2 hiding = foot;
    for (float far = 1.0; far < 40.0 && !found; far *= 1.8) {
        place = foot + far * inward;
        float there = finished(place);
        bool nearer = there < depth + near;
        found = nearer && there > before;
        if (nearer && !hidden) hiding = place;
        hidden = hidden || nearer;
    }
    if (!found) place = hiding;
    found = found || hidden;
    place = clamp(place, port.xy, port.zw);
    return found ? vec4(texelFetch(app_colour, ivec2(place), 0).rgb, 1.0) : vec4(0.0);
}

void main() {
    float grain = max(length(dFdx(root)), length(dFdy(root)));
    float covered = 1.0, tip = 1.0;
    vec4 random = vec4(0.5);
    if (height > SKIN) {
        // Neighbours lean together: locks.
        vec3 sway = sin(0.37 * root.yzx + 2.0 * sin(0.23 * root.zxy));
        vec3 q = root + 0.3 * sin(1.9 * root.zxy) + curl * height * height * sway;
        ivec3 at = ivec3(floor(q));
        random = random_of(at);
        vec3 kink = 0.12 * curl * sin(5.0 * height + 6.28 * random.yzx);
        // Mostly along the surface: a cell that the surface cuts far off its middle has a hair too.
        vec3 off = q - vec3(at) - 0.5 - 0.5 * (random.xyz - 0.5) + height * kink;
        float apart = length(off - 0.75 * dot(off, upright) * upright);
        tip = (0.55 + 0.45 * random.w) * (0.88 + 0.12 * sway.x);
        float radius = thickness * sqrt(max(1.0 - height / tip, 0.0));
        // Not wider than half a hair: what is dense would turn into haze.
        covered = radius > 0.0
            ? clamp((radius - apart) / clamp(grain, 0.1, 0.5) + 0.5, 0.0, 1.0) : 0.0;
    }
    covered *= fade;
    // What is nearly clear would hide the hairs behind it.
    bool clear = covered < 0.3;
    vec4 own = vec4(fur_colour.rgb * (0.3 + 0.8 * lit.x), fur_colour.a);
    // A loop, since drivers in software leave loops early but walk through every branch.
    for (int k = 0; k < (clear || own.a > 0.0 ? 0 : 1); ++k) own = grown_from();
    if (clear || own.a == 0.0) discard;
    // Roots lie in the shadow of the hairs around them.
    float up = clamp(height / tip, 0.0, 1.0);
    float shade = mix(0.38, 1.12, up) * (0.84 + 0.32 * random.x);
    vec3 shine = sheen * lit.y * up * (0.4 + 0.6 * random.y) * mix(vec3(1.0), own.rgb, 0.5);
    covered = min(covered + 0.3, 1.0);
    colour = vec4(clamp(own.rgb * shade + shine, 0.0, 1.0) * covered, covered);
}
