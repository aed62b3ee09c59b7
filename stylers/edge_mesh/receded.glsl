// What:   the layer's finished depth, moved away from the viewer as glPolygonOffset would.
// Inputs: that depth, and by how many slopes.
// Source: McGuire & Hughes 2004, section 3.5. The slope is the greater one to both sides: at an
//         outline that lets go of one pixel, where the lesser would break lines along thin faces.

uniform float factor;

float steepest(vec2 centre, vec2 aside, float depth) {
    return max(abs(finished(centre - aside) - depth), abs(finished(centre + aside) - depth));
}

// Depth, greater for farther.
float receded(vec2 centre) {
    float depth = finished(centre);
    vec2 slope = vec2(steepest(centre, vec2(1.0, 0.0), depth),
                      steepest(centre, vec2(0.0, 1.0), depth));
    return depth + factor * length(slope) + 2.0 * hair;
}
