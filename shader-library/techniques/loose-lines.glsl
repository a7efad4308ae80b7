/*{
  "DESCRIPTION": "Draws objects as a quick sketch: three loose strokes follow each silhouette and are redrawn a few times a second. Between the lines is a thin wash of the object's color.",
  "CREDIT": "Scrim. After Curtis, Loose and Sketchy Animation, SIGGRAPH 1998; strokes by hulls around the object instead of particles",
  "CATEGORIES": ["Sketch", "Sketchy", "Lines", "Pencil", "Drawing", "Jitter", "Boil", "Wobble", "NPR"],
  "PASSES": [{ "SIDE": "object" }, { "SIDE": "back" }, { "SIDE": "back" }, { "SIDE": "back" }, { "SIDE": "back" }, { "SIDE": "back" }, { "SIDE": "back" }],
  "INPUTS": [
    { "NAME": "strokePx", "TYPE": "float", "LABEL": "Stroke", "DOC": "Width of a stroke on screen.", "MIN": 0.5, "MAX": 8.0, "DEFAULT": 2.0, "STEP": 0.5, "UNIT": "px" },
    { "NAME": "loosePx", "TYPE": "float", "LABEL": "Looseness", "DOC": "How far strokes deviate from the silhouette.", "MIN": 0.0, "MAX": 24.0, "DEFAULT": 5.0, "UNIT": "px" },
    { "NAME": "waveM", "TYPE": "float", "LABEL": "Wavelength", "DOC": "Length of the waves of a stroke.", "MIN": 0.005, "MAX": 1.0, "DEFAULT": 0.06, "UNIT": "m" },
    { "NAME": "rate", "TYPE": "float", "LABEL": "Redraw rate", "DOC": "How many times a second the strokes are redrawn. 0 leaves them as they are.", "MIN": 0.0, "MAX": 24.0, "DEFAULT": 4.0, "IDENTITY": 0.0, "UNIT": "Hz" },
    { "NAME": "seed", "TYPE": "float", "LABEL": "Seed", "DOC": "Another seed gives other strokes.", "MIN": 0.0, "MAX": 100.0, "DEFAULT": 1.0, "STEP": 1.0 },
    { "NAME": "inkColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the strokes.", "DEFAULT": [0.12, 0.1, 0.14, 1.0] },
    { "NAME": "washColor", "TYPE": "color", "LABEL": "Wash", "DOC": "Color between the lines. With alpha below 1, what is behind the object shows through.", "DEFAULT": [1.0, 0.98, 0.94, 1.0] },
    { "NAME": "ownColor", "TYPE": "float", "LABEL": "Own color", "DOC": "How much of the object's own color the wash has.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.45, "UNIT": "ratio" },
    { "NAME": "shade", "TYPE": "float", "LABEL": "Shade", "DOC": "How much darker the wash is where there is little light.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.4, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/
#include <light/received>
#include <light/white>
#include <noise/value-3d>

// Each stroke has two hulls: the inner one masks the inside of the outer one.
int strokeOf(const in int pass) {
  return (pass - 1) / 2;
}

// A point of the noise that is unique to a stroke and a redraw.
vec3 momentOf(const in int stroke) {
  float drawing = floor(TIME * rate + 0.0001) + seed * 61.0;
  return hash3d(vec3(float(stroke), drawing, 5.0)) * 512.0;
}

void vertex(inout Vertex v) {
  if (PASSINDEX == 0) return;
  int stroke = strokeOf(PASSINDEX);
  float pixelM = PIXEL_M(v.position);
  vec3 wander = valueNoise3d(v.rest / waveM + momentOf(stroke)) - 0.5;
  float fromShape = 0.4 * loosePx * float(stroke);
  float isOuter = PASSINDEX % 2 == 0 ? 1.0 : 0.0;
  v.position += (v.outward * (fromShape + isOuter * strokePx) + 2.0 * loosePx * wander) * pixelM;
}

vec4 surface(const in Surface s) {
  if (PASSINDEX == 0) {
    float brightest = max(min(lightOnWhite(), 1.0), 0.00001);
    float light = smoothstep(0.05, 0.75, lightReceived(s) / brightest);
    vec3 wash = mix(vec3(1.0), s.color.rgb, ownColor) * washColor.rgb * mix(1.0 - shade, 1.0, light) * brightest;
    return vec4(wash, washColor.a * s.color.a);
  }
  // Invisible, but it writes depth.
  if (PASSINDEX % 2 == 1) return vec4(0.0);
  // The pressure of the pen varies.
  float pressed = valueNoise3d(s.rest / (0.7 * waveM) + momentOf(strokeOf(PASSINDEX)).yzx).x;
  float strength = smoothstep(0.12, 0.5, pressed) * (1.0 - 0.2 * float(strokeOf(PASSINDEX)));
  return vec4(inkColor.rgb, inkColor.a * s.color.a * strength);
}
