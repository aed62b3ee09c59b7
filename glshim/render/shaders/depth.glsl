// Prelude of every line shader's fragments: the layer's finished depth. Also for GLSL 1.20.

#if __VERSION__ >= 130
#define FROM_VERTEX flat in
out vec4 colour;
#else
#define FROM_VERTEX varying
#define colour gl_FragColor
#define texture texture2D
#endif

uniform sampler2D finished_depth;  // window depth of the framebuffer
uniform vec2 depth_size;           // pixels of that texture
uniform vec4 port;                 // the viewport: least and greatest pixel centre
uniform float away;                // +1 where greater depth is farther away, else -1
uniform float blur;                // pixels by which depths may not be those of pixel centres

// Depth, greater for farther, of what is drawn in the pixel with a centre.
float finished(vec2 centre) {
    return away * texture(finished_depth, clamp(centre, port.xy, port.zw) / depth_size).r;
}

// The centre of the nearest pixel beyond a line through a place: outwards is a unit vector.
vec2 beyond(vec2 place, vec2 outwards) {
    float least = 0.04 + blur, nearest = 9.0;
    vec2 corner = floor(place + (least + 0.01) * outwards - 0.5) + 0.5, found = corner;
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
            vec2 centre = corner + vec2(i, j);
            float distance = dot(centre - place, outwards);
            if (distance > least && distance < nearest) { nearest = distance; found = centre; }
        }
    }
    return found;
}
