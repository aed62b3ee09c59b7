// What: pass 1 (TRAP 0) notes for each pixel the visible triangle D; pass 2 (TRAP 1) traps the
// triangles P behind D that come out of it a pixel or so away.
// Inputs: the number of the draw's first triangle; the app's finished depth; what pass 1 noted.
// Source: Raskar 2001, section 2.4: P lies between D and a second depth, which the paper takes to
// be a little farther. Here the slopes of both say how far: lines come out equally wide at any angle.

uniform int first_triangle;
uniform float away;         // +1 where greater depth is farther away, else -1
uniform sampler2D finished; // the app's finished depth
uniform ivec3 finished_at;  // the texel of it that lies at our pixel 0, 0; whether there is any
uniform usampler2D seen;    // what pass 1 noted

out uvec4 note;             // pass 1: D's number + 1, bits of its slope (2) and depth; 2: P, D (+ 1)

const float NEAR = 1.5;     // pixels from the crossing
const float HAIR = 4.0 / 16777216.0;

void main() {
    float depth = gl_FragCoord.z;
    vec2 slope = vec2(dFdx(depth), dFdy(depth));
    uint number = uint(gl_PrimitiveID + first_triangle + 1);
#if TRAP
    uvec4 other = texelFetch(seen, ivec2(gl_FragCoord.xy), 0);
    float behind = away * (depth - uintBitsToFloat(other.w));
    float reach = NEAR * distance(slope, uintBitsToFloat(other.yz));
    if (other.x == 0u || other.x == number || behind < -HAIR || behind > reach) discard;
    note = uvec4(number, other.x, 0u, 0u);
#else
    if (finished_at.z != 0) {
        // What is not in the app's picture (hidden by what the shim does not know, dropped by an
        // alpha test) is not seen. The app's depth may be that of another place in the pixel.
        float app = texelFetch(finished, ivec2(gl_FragCoord.xy) + finished_at.xy, 0).r;
        if (abs(depth - app) > NEAR * (abs(slope.x) + abs(slope.y)) + 4.0 * HAIR) discard;
    }
    note = uvec4(number, floatBitsToUint(slope), floatBitsToUint(depth));
#endif
}
