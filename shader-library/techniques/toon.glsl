/*{
  "DESCRIPTION": "Draws objects as a cartoon: flat steps of light and an outline, also around the borders of open surfaces. The steps darken the object's own color, or take their colors from a ramp image, from dark at its left to bright at its right.",
  "CREDIT": "Scrim. Steps: Lake, Marshall, Harris, Blackstein, Stylized Rendering Techniques for Scalable Real-Time 3D Animation, NPAR 2000; outline by inverted hull, and by lines at borders",
  "CATEGORIES": ["Cartoon", "Cel", "Comic", "Anime", "Outline", "Ramp", "NPR"],
  "SCRIM_RENAMED": [{ "outlineM": { "TO": "outlinePx", "TIMES": 750 } }],
  "PASSES": [{ "SIDE": "object" }, { "SIDE": "back" }, { "SIDE": "edges", "OPEN": true }],
  "INPUTS": [
    { "NAME": "ramp", "TYPE": "image", "LABEL": "Ramp", "DOC": "Image whose middle row colors the steps, dark to bright from left to right. Not connected: “Shadow brightness” sets the steps.", "OPTIONAL": true, "SPACE": "picture" },
    { "NAME": "levels", "TYPE": "long", "LABEL": "Levels", "DOC": "Number of steps of light.", "VALUES": [1, 2, 3, 4, 5, 6], "LABELS": ["1", "2", "3", "4", "5", "6"], "DEFAULT": 3 },
    { "NAME": "darkest", "TYPE": "float", "LABEL": "Shadow brightness", "DOC": "Brightness of the darkest step; the brightest shows the object's own color.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.25, "UNIT": "ratio" },
    { "NAME": "outlinePx", "TYPE": "float", "LABEL": "Outline", "DOC": "Width of the outline on screen. 0 turns it off.", "MIN": 0.0, "MAX": 16.0, "DEFAULT": 3.0, "IDENTITY": 0.0, "STEP": 0.5, "UNIT": "px" },
    { "NAME": "outlineColor", "TYPE": "color", "LABEL": "Outline color", "DOC": "Color of the outline.", "DEFAULT": [0.05, 0.04, 0.08, 1.0] }
  ]
}*/
#include <light/received>
#include <light/white>

const int HULL = 1;
// An open surface has no back that a hull could show around it.
const int LINES = 2;

void vertex(inout Vertex v) {
  if (PASSINDEX == HULL) v.position += v.outward * (outlinePx * PIXEL_M(v.position));
  if (PASSINDEX == LINES) v.widthPx = v.contour ? outlinePx : 0.0;
}

vec3 stepColor(const in float level) {
  float last = float(levels - 1);
  vec4 toned = IMG_NORM_PIXEL(ramp, vec2((level + 0.5) / float(levels), 0.5));
  if (toned.a > 0.0) return toned.rgb;
  return vec3(last > 0.0 ? mix(darkest, 1.0, level / last) : 1.0);
}

vec4 surface(const in Surface s) {
  if (PASSINDEX == HULL || PASSINDEX == LINES) {
    // Without a width, the hull and the object would z-fight.
    if (outlinePx <= 0.0) discard;
    return vec4(outlineColor.rgb, outlineColor.a * s.color.a);
  }
  // The steps divide the light that there is. Where it is less than white needs, all steps are darker.
  float brightest = max(min(lightOnWhite(), 1.0), 0.00001);
  float steps = min(lightReceived(s) / brightest, 1.0) * float(levels);
  float last = float(levels - 1);
  // Antialiasing: a step rises over the width of a pixel.
  float border = floor(steps + 0.5);
  float up = clamp((steps - border) / max(length(vec2(dFdx(steps), dFdy(steps))), 0.0001) + 0.5, 0.0, 1.0);
  vec3 light = mix(stepColor(clamp(border - 1.0, 0.0, last)), stepColor(clamp(border, 0.0, last)), up);
  return vec4(s.color.rgb * light * brightest, s.color.a);
}
