// What:   the depth of what looks away, for contours that nothing else shall hide.
// Inputs: n.c of the smooth surface (back.vert.glsl).
// Source: Hajagos et al. 2012, section 5.

in float facing_us;

void main() {
    if (facing_us >= 0.0) discard;
    colour = vec4(0.0, 0.0, 0.0, gl_FragCoord.z);
}
