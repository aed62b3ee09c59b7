// Prelude of every line shader, in both stages: the layer's finished depth, the kinds of line, and
// PASSED, which declares what goes from the vertex to the fragment. Also for GLSL 1.20.

#if __VERSION__ < 130
#define PASSED varying
#define colour gl_FragColor
#define texture texture2D
#elif defined(VERTEX_STAGE) || defined(GEOMETRY_STAGE)
#define PASSED flat out
#else
#define PASSED flat in
out vec4 colour;
#endif

uniform sampler2D finished_depth;  // window depth of the framebuffer
uniform vec2 depth_size;           // pixels of that texture
uniform vec4 port;                 // the viewport: least and greatest pixel centre
uniform float away;                // +1 where greater depth is farther away, else -1
uniform float hair;                // a few steps of the depth buffer
uniform vec3 shot;                 // pixels from the picture's corner to ours; ours for a window's
uniform float blur;                // pixels by which depths may not be those of pixel centres

const int RING = 0, CONTOUR = 1, HOLLOW = 2, FIN = 3, RIDGE = 4, LONE_RIDGE = 5, VALLEY = 6,
          LONE_VALLEY = 7, INTERSECTION = 8;  // glshim/model/lines.py

// Depth, greater for farther, of what is drawn in the pixel with a centre.
float finished(vec2 centre) {
    centre = clamp(centre, port.xy, port.zw);
#if __VERSION__ >= 130
    return away * texelFetch(finished_depth, ivec2(centre), 0).r;
#else
    return away * texture2D(finished_depth, centre / depth_size).r;
#endif
}

// The centre of a pixel beyond a line through a place: 0.04 to 1.46 pixels outwards (a unit
// vector).
vec2 beyond(vec2 place, vec2 outwards) {
    return floor(place + (0.75 + blur) * outwards) + 0.5;
}
