// What:   ink on a fin of a few pixels, which the geometry shader has found to be seen.
// Inputs: the fin (fins.geom.glsl, SHORT_FINS). Distances are in pixels, so that a derivative is 1.
// Source: Rideout 2010, "Antialiased Fins".

uniform vec3 ink;
uniform float half_width;
uniform float tip;
uniform int joints;

flat in float edge;
noperspective in vec3 reach;

const int ROUND_JOINTS = 2;

void main() {
    float past = joints == ROUND_JOINTS ? reach.x - clamp(reach.x, 0.0, edge) : 0.0;
    float inside = half_width - length(vec2(past, reach.y));
    float alpha = tip > 0.0 ? clamp(inside / tip, 0.0, 1.0) : step(0.0, inside);
    colour = vec4(alpha * ink, alpha);
}
