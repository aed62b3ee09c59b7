// What:   the G-buffer: places of surfaces on their objects, and how large a pixel is there.
// Inputs: held.vert.glsl, the camera, whether the app lit it.

uniform mat4 projection;
uniform vec4 viewport;

uniform float lit;  // 1, or 0: a pattern by the light has none here

in vec3 held;

void main() {
    // Of a surface that faces the viewer: what depends on depth alone is the same across facets.
    float pixel = 2.0 / (gl_FragCoord.w * abs(projection[1][1]) * viewport.w);
    colour = vec4(held, log2(max(pixel, 1e-30)) + (lit == 1.0 ? 256.0 : 1024.0));
}
