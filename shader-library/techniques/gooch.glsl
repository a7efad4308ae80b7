/*{
  "DESCRIPTION": "Shades objects from cool to warm tones, as technical illustrations do: surfaces that face the light are warm, others are cool, and none is black, so the shape is visible everywhere. Outlines follow the silhouettes, and the borders of open surfaces. The strongest light sets the direction of the tones, and all light their brightness; the environment counts as a light from its brightest side. “Color of the light” gives the tones the colors of the light.",
  "CREDIT": "Scrim. Gooch, Gooch, Shirley, Cohen: A Non-Photorealistic Lighting Model for Automatic Technical Illustration, SIGGRAPH 1998, sections 4.1 and 4.2",
  "CATEGORIES": ["Illustration", "Technical", "NPR", "Cool", "Warm", "Tone", "CAD", "Silhouette"],
  "PASSES": [{ "SIDE": "object" }, { "SIDE": "back" }, { "SIDE": "edges", "OPEN": true }],
  "INPUTS": [
    { "NAME": "coolColor", "TYPE": "color", "LABEL": "Cool", "DOC": "Color of surfaces that face away from the light.", "DEFAULT": [0.1, 0.2, 0.75, 1.0] },
    { "NAME": "warmColor", "TYPE": "color", "LABEL": "Warm", "DOC": "Color of surfaces that face the light.", "DEFAULT": [0.85, 0.7, 0.15, 1.0] },
    { "NAME": "coolShare", "TYPE": "float", "LABEL": "Own color, cool", "DOC": "How much of the object's own color is added to the cool tone.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.25, "UNIT": "ratio" },
    { "NAME": "warmShare", "TYPE": "float", "LABEL": "Own color, warm", "DOC": "How much of the object's own color is added to the warm tone.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "lightColor", "TYPE": "float", "LABEL": "Color of the light", "DOC": "How much the tones take the color of the light: the warm tone and the highlight that of the strongest light, the cool tone that of the light from the other side. White light changes no tone, and no tone gets brighter or darker.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "highlight", "TYPE": "float", "LABEL": "Highlight", "DOC": "Strength of the white highlight.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.7, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "sharpness", "TYPE": "float", "LABEL": "Sharpness", "DOC": "Phong exponent: a higher value gives a smaller highlight.", "MIN": 1.0, "MAX": 200.0, "DEFAULT": 40.0 },
    { "NAME": "linePx", "TYPE": "float", "LABEL": "Silhouette", "DOC": "Width of the outline on screen. 0 turns it off.", "MIN": 0.0, "MAX": 12.0, "DEFAULT": 2.0, "IDENTITY": 0.0, "STEP": 0.5, "UNIT": "px" },
    { "NAME": "lineColor", "TYPE": "color", "LABEL": "Silhouette color", "DOC": "Color of the outline.", "DEFAULT": [0.02, 0.02, 0.04, 1.0] }
  ]
}*/
#include <light/diffuse>
#include <light/luminance>
#include <light/strongest>
#include <light/white>

const int HULL = 1;
// An open surface has no back that a hull could show around it.
const int LINES = 2;

void vertex(inout Vertex v) {
  if (PASSINDEX == HULL) v.position += v.outward * (linePx * PIXEL_M(v.position));
  if (PASSINDEX == LINES) v.widthPx = v.contour ? linePx : 0.0;
}

// A tone in light of a color, as bright as in white light.
vec3 toneIn(const in vec3 light, const in vec3 tone) {
  vec3 lit = light * tone;
  float bright = luminance(lit);
  return bright > 0.000001 ? mix(tone, lit * (luminance(tone) / bright), lightColor) : tone;
}

vec4 surface(const in Surface s) {
  if (PASSINDEX == HULL || PASSINDEX == LINES) {
    // Without a width, the hull and the object would z-fight.
    if (linePx <= 0.0) discard;
    return vec4(lineColor.rgb, lineColor.a * s.color.a);
  }
  Light light = strongestLight(s);
  float facing = dot(s.normal, light.towards);
  // In shadow, and outside the cone of a spot light, a surface is as warm as at a grazing angle.
  float lit = lightStrength(light) > 0.0 ? light.lit : 0.0;
  float reached = facing > 0.0 ? facing * lit : facing;
  vec3 cool = coolColor.rgb + coolShare * s.color.rgb;
  vec3 warm = warmColor.rgb + warmShare * s.color.rgb;
  vec3 shiny = vec3(1.0);
  if (lightColor > 0.0) {
    cool = toneIn(diffuseLight(-light.towards), cool);
    warm = toneIn(light.radiance, warm);
    shiny = toneIn(light.radiance, shiny);
  }
  float brightest = min(lightOnWhite(), 1.0);
  vec3 tone = mix(cool, warm, 0.5 + 0.5 * reached) * brightest;
  float mirrored = max(dot(reflect(-light.towards, s.normal), s.towardsEye), 0.0);
  float shine = facing > 0.0 ? highlight * lit * pow(mirrored, sharpness) : 0.0;
  return vec4(mix(tone, shiny * brightest, shine), s.color.a);
}
