// What:   flat ink, rounded at corners; a ring or a fin where its spine is seen.
// Inputs: reach and the spine from raskar.vert.glsl; ink.

noperspective in vec2 reach;
noperspective in vec3 spine;
flat in vec2 spine_slope, spine_out;
flat in float spine_slack, spine_free;
flat in int spine_places;
uniform vec3 ink;
out vec4 colour;

bool unseen() {
    if (spine_places == 0 || length(reach) < spine_free) return false;
    vec3 place = spine;
    for (int i = 0; i < spine_places; ++i) {
        if (!hidden(place, spine_slope, spine_out, spine_slack)) return false;
        place += vec3(spine_out, dot(spine_slope, spine_out));
    }
    return true;
}

void main() {
    if (dot(reach, reach) > 1.0001 || unseen()) discard;
    colour = vec4(ink, 1.0);
}
