// What: pass 1 (TRAP 0) notes for each pixel the visible triangle D; pass 2 (TRAP 1) traps the
// triangles P behind D that come out of it a pixel or so away.
// Inputs: the number of the draw's first triangle; the app's finished depth; what pass 1 noted.
// Source: Raskar 2001, section 2.4: P lies between D and a second depth, which the paper takes to
// be a little farther. Here the slopes of both say how far: lines come out equally wide at any
// angle.

uniform int first_triangle;
uniform float away;         // +1 where greater depth is farther away, else -1
uniform sampler2D finished; // the app's finished depth, a texel a pixel of its framebuffer
uniform ivec2 corner_at;    // which of those our pixel 0, 0 is
uniform float hair;         // a few steps of that depth
uniform usampler2D seen;    // what pass 1 noted

out uvec4 note;             // pass 1: D, bits of its slope (2) and depth; pass 2: P, D
                            // where a triangle is its number + 1, and 1 << 31 if it faces us

const float NEAR = 1.5;     // pixels from the crossing
const float ELSEWHERE = 4.0;  // pixels in which the app's depth may be that of this triangle
const float HAIR = 4.0 / 16777216.0;

void main() {
    float depth = gl_FragCoord.z;
    vec2 slope = vec2(dFdx(depth), dFdy(depth));
    uint number = uint(gl_PrimitiveID + first_triangle + 1) | (gl_FrontFacing ? 1u << 31 : 0u);
#if TRAP
    uvec4 other = texelFetch(seen, ivec2(gl_FragCoord.xy), 0);
    float behind = away * (depth - uintBitsToFloat(other.w));
    float reach = NEAR * distance(slope, uintBitsToFloat(other.yz));
    if (other.x == 0u || other.x == number || behind < -HAIR || behind > reach) discard;
    note = uvec4(number, other.x, 0u, 0u);
#else
    // What is not in the app's picture (hidden by what the shim does not know, dropped by an alpha
    // test) is not seen. Several samples and polygon offset move the app's depth a little.
    float app = texelFetch(finished, ivec2(gl_FragCoord.xy) + corner_at, 0).r;
    if (abs(depth - app) > ELSEWHERE * length(slope) + hair) discard;
    note = uvec4(number, floatBitsToUint(slope), floatBitsToUint(depth));
#endif
}
