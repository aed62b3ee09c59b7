// What:   where a dimension is drawn: along and out from the line that it measures. For both
//         stages.
// Source: NPRQuake's blueprint: dimension arrows here and there.

PASSED vec2 dimension;   // the line's length in eye space; characters of its number

#define OFF (15.0 * shot.z)  // pixels from the line to its dimension line
#define HIGH (11.0 * shot.z) // pixels of a character
#define WIDE (7.0 * shot.z)
const float MOST = 99999.0; // units that are written

// Digits after the point: three that count, in all.
float decimals(float length) {
    return clamp(2.0 - floor(log(length) / log(10.0) + 1e-4), 0.0, 3.0);
}
