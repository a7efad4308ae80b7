/*{
  "DESCRIPTION": "Draws objects like a cartoon: flat steps of light and an outline. The outline is the object once more, a little larger and turned inside out, so that edges between faces with a hard crease have gaps in it; smooth shapes have none.",
  "CREDIT": "Scrim. Steps: Lake, Marshall, Harris, Blackstein, Stylized Rendering Techniques for Scalable Real-Time 3D Animation, NPAR 2000; outline by inverted hull",
  "CATEGORIES": ["Cartoon", "Cel", "Comic", "Anime", "Outline", "Ramp", "NPR"],
  "PASSES": [{ "SIDE": "back" }, { "SIDE": "object" }],
  "INPUTS": [
    { "NAME": "levels", "TYPE": "long", "LABEL": "Levels", "DOC": "How many steps of light there are.", "VALUES": [1, 2, 3, 4, 5, 6], "LABELS": ["1", "2", "3", "4", "5", "6"], "DEFAULT": 3 },
    { "NAME": "darkest", "TYPE": "float", "LABEL": "Darkest", "DOC": "Brightness of the darkest step; the brightest shows the object's own colour.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.25, "UNIT": "ratio" },
    { "NAME": "outlineM", "TYPE": "float", "LABEL": "Outline", "DOC": "How wide the outline is in the room. 0 is none.", "MIN": 0.0, "MAX": 0.05, "DEFAULT": 0.004, "IDENTITY": 0.0, "STEP": 0.001, "UNIT": "m" },
    { "NAME": "outlineColor", "TYPE": "color", "LABEL": "Outline colour", "DOC": "Colour of the outline.", "DEFAULT": [0.05, 0.04, 0.08, 1.0] }
  ]
}*/
#include <light/strength>

void vertex(inout Vertex v) {
  if (PASSINDEX == 0) v.position += v.normal * outlineM;
}

// Light received of all there is, from 0 to 1, whatever its strength. Without lights it comes from the eye.
float received(const in Surface s) {
  if (LIGHT_COUNT == 0) return max(dot(s.normal, s.towardsEye), 0.0);
  float sum = 0.0;
  float most = 0.0;
  for (int i = 0; i < LIGHT_COUNT; i++) {
    Light light = LIGHT(i);
    float strength = lightStrength(light);
    sum += strength * max(dot(s.normal, light.towards), 0.0) * light.lit;
    most += strength;
  }
  return most > 0.0 ? sum / most : 0.0;
}

vec4 surface(const in Surface s) {
  if (PASSINDEX == 0) {
    // Without a width the hull would fight with the object that it lies on.
    if (outlineM <= 0.0) discard;
    return vec4(outlineColor.rgb, outlineColor.a * s.color.a);
  }
  float last = float(levels - 1);
  float level = min(floor(received(s) * float(levels)), last);
  float bright = last > 0.0 ? mix(darkest, 1.0, level / last) : 1.0;
  return vec4(s.color.rgb * bright, s.color.a);
}
