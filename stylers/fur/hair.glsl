// What:   a vertex of a shell or a fin: where it is, and what the hairs there need to know.
// Inputs: the mesh (mesh.glsl); the length of hairs and the distance between them, object units.
// Source: Lengyel et al. 2001, section 3; Kajiya & Kay 1989 for the light on a hair.

uniform float hair_length;
uniform float spacing;
uniform float droop;
uniform float reach;    // size of the object
uniform mat3 lattice;   // turns object space, so that no face lies along a layer of cells

out vec3 root;          // at rest, in cells
out vec3 upright;       // the normal there
out float height;       // 0 at the root, 1 at the tip
out float fade;
out vec4 ground;        // clip space, of the root
out vec2 nearest;       // clip space z and w of what may hide the root and is still the object
out vec2 inward;        // pixels, towards the object
out vec3 lit;           // Lambert's term, wrapped; Kajiya & Kay's sheen; if the root faces away

// The normal out of the object; out of a sheet, to the viewer.
vec3 out_of(int v, vec3 place) {
    vec3 n = normal(v);
    return rest(v).w == 0.0 && dot(n, towards(eye, place)) < 0.0 ? -n : n;
}

// The end of a hair at a height: bent towards the lower rim of the picture, never longer than 1.
vec3 bent(vec3 n, float t) {
    vec3 down = -normalize(vec3(0.0, 1.0, 0.0) * mat3(modelview));
    return t * normalize(n + droop * t * (down - 0.5 * dot(down, n) * n));
}

void grow(int v, vec3 place, vec3 n, float t) {
    vec3 hair_way = bent(n, t);
    root = lattice * rest(v).xyz / spacing;
    upright = lattice * n;
    height = t;
    fade = 1.0;
    ground = clip(place);
    vec3 view = normalize(towards(eye, place)), lamp = normalize(towards(light, place));
    nearest = clip(place + reach * view).zw;
    vec4 under = clip(place - hair_length * n);
    inward = pixels(under) - pixels(ground);
    inward /= max(length(inward), 1e-4);
    vec3 way = normalize(mix(n, hair_way, 0.9) + 1e-6);
    float along_light = dot(way, lamp), along_view = dot(way, view);
    float across = sqrt(max(1.0 - along_light * along_light, 0.0))
                 * sqrt(max(1.0 - along_view * along_view, 0.0)) - along_light * along_view;
    float lambert = dot(n, lamp);
    lit = vec3(clamp(0.65 * lambert + 0.35, 0.0, 1.0),
               pow(max(across, 0.0), 24.0) * smoothstep(-0.2, 0.5, lambert), -dot(n, view));
    gl_Position = clip(place + hair_length * hair_way);
}
