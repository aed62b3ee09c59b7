// What:   flat ink, rounded at corners; a ring or a fin where its spine is seen.
// Inputs: reach and the spine from raskar.vert.glsl; ink.

noperspective in vec2 reach;
noperspective in vec3 spine;
flat in vec3 spine_again;
flat in float spine_slack, spine_asked;
uniform vec3 ink;
out vec4 colour;

bool unseen() {
    return hidden(spine, spine_slack)
        && (spine_again.xy == vec2(0.0) || hidden(spine + spine_again, spine_slack));
}

void main() {
    if (dot(reach, reach) > 1.0001) discard;
    if (spine_asked > 0.0 && unseen()) discard;
    colour = vec4(ink, 1.0);
}
