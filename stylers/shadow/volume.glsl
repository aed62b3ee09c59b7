// Of all vertex shaders of the style: the way to infinity.

uniform bool mirrored;   // the camera turns windings round

// A direction of clip space that leads away from the viewer.
float deeper() { return sign(range.y - range.x); }

// Where a place goes, in clip space, when the light drives it to infinity. Under a parallel
// projection infinity has no image: there it goes a thousand windows far.
vec4 driven(vec3 place) {
    vec4 way = projection * (modelview * vec4(-towards(light, place), 0.0));
    bool parallel = vec3(projection[0].w, projection[1].w, projection[2].w) == vec3(0.0);
    if (!parallel) return way;
    vec4 here = clip(place);
    vec3 size = abs(here.xyz), speed = abs(way.xyz);
    float far = 1000.0 * (here.w + max(size.x, max(size.y, size.z)));
    return here + way * (far / max(max(speed.x, max(speed.y, speed.z)), 1e-30));
}
