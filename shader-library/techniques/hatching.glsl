/*{
  "DESCRIPTION": "Draws objects as pen hatching: darker areas get more strokes. The strokes stay on the object and keep their width on screen at any distance.",
  "CREDIT": "Scrim. Praun, Hoppe, Webb, Finkelstein: Real-Time Hatching, SIGGRAPH 2001",
  "CATEGORIES": ["Hatch", "Pen", "Ink", "Drawing", "Sketch", "Engraving", "NPR", "Tonal art map"],
  "PASSES": [{ "SIDE": "object" }, { "SIDE": "back" }],
  "IMPORTED": { "lightTones": { "PATH": "pictures/hatching-light.png" }, "darkTones": { "PATH": "pictures/hatching-dark.png" } },
  "INPUTS": [
    { "NAME": "sizeM", "TYPE": "float", "LABEL": "Size", "DOC": "Size of the stroke pattern on the object before it repeats. A larger pattern has longer, wider strokes close up.", "MIN": 0.005, "MAX": 2.0, "DEFAULT": 0.16, "UNIT": "m" },
    { "NAME": "turn", "TYPE": "float", "LABEL": "Direction", "DOC": "Angle of the first strokes on the object.", "MIN": -3.14159, "MAX": 3.14159, "DEFAULT": 0.6, "UNIT": "rad" },
    { "NAME": "mapping", "TYPE": "long", "LABEL": "Mapping", "DOC": "Whether strokes follow the local axes of the object or its texture coordinates (UV). Use UV for models with good texture coordinates.", "VALUES": [0, 1], "LABELS": ["Axes", "Picture coordinates"], "DEFAULT": 0 },
    { "NAME": "brightness", "TYPE": "float", "LABEL": "Brightness", "DOC": "Lightens or darkens the drawing.", "MIN": -1.0, "MAX": 1.0, "DEFAULT": 0.05, "UNIT": "ratio" },
    { "NAME": "ownTone", "TYPE": "float", "LABEL": "Own tone", "DOC": "How much dark colors of the object add strokes.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "inkColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the strokes.", "DEFAULT": [0.09, 0.08, 0.12, 1.0] },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color between the strokes. With less opacity what is behind the object shows through.", "DEFAULT": [0.97, 0.95, 0.9, 1.0] },
    { "NAME": "ownColor", "TYPE": "float", "LABEL": "Own color", "DOC": "How much of the object's own color the ink has.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "linePx", "TYPE": "float", "LABEL": "Outline", "DOC": "Width of the outline on screen. 0 turns it off.", "MIN": 0.0, "MAX": 12.0, "DEFAULT": 1.5, "IDENTITY": 0.0, "STEP": 0.5, "UNIT": "px" }
  ]
}*/
#include <light/received>

void vertex(inout Vertex v) {
  if (PASSINDEX == 1) v.position += v.outward * (linePx * PIXEL_M(v.position));
}

// The ink of the tonal art map at a point, for a darkness from 0 (white) to 6: a blend of the two nearest tones.
float inkAt(const in vec2 place, const in float darkness) {
  vec3 light = 1.0 - texture(lightTones, place).rgb;
  vec3 dark = 1.0 - texture(darkTones, place).rgb;
  vec3 lightWeights = max(1.0 - abs(darkness - vec3(1.0, 2.0, 3.0)), 0.0);
  vec3 darkWeights = max(1.0 - abs(darkness - vec3(4.0, 5.0, 6.0)), 0.0);
  return dot(light, lightWeights) + dot(dark, darkWeights);
}

// The darkness at which the mean ink of the map is `covered`; the tones of its pictures are those of `make-tonal-art-maps`.
float darknessOf(const in float covered) {
  vec3 light = clamp((covered - vec3(0.0, 0.1, 0.22)) / vec3(0.1, 0.12, 0.14), 0.0, 1.0);
  vec3 dark = clamp((covered - vec3(0.36, 0.5, 0.65)) / vec3(0.14, 0.15, 0.15), 0.0, 1.0);
  return dot(light + dark, vec3(1.0));
}

vec4 surface(const in Surface s) {
  vec3 ink = mix(inkColor.rgb, s.color.rgb * 0.5, ownColor);
  if (PASSINDEX == 1) {
    if (linePx <= 0.0) discard;
    return vec4(ink, inkColor.a * s.color.a);
  }
  float own = dot(s.color.rgb, vec3(0.2126, 0.7152, 0.0722));
  // The eye averages strokes and paper in linear light, so the part of paper is the luminance that a white surface has in this light.
  float lit = lightReceived(s) * mix(1.0, pow(own, 0.45), ownTone);
  float tone = pow(lit, (1.0 - brightness) / max(1.0 + brightness, 0.001));
  float darkness = darknessOf(1.0 - tone);

  mat2 turned = mat2(cos(turn), sin(turn), -sin(turn), cos(turn)) * (1.0 / sizeM);
  float ink0 = inkAt(turned * s.rest.zy, darkness);
  float ink1 = inkAt(turned * s.rest.xz, darkness);
  float ink2 = inkAt(turned * s.rest.xy, darkness);
  float byPicture = inkAt(s.uv * 3.0, darkness);
  vec3 sides = pow(abs(s.restNormal), vec3(6.0));
  sides /= sides.x + sides.y + sides.z;
  float covered = mapping == 1 ? byPicture : dot(sides, vec3(ink0, ink1, ink2));
  // The darkest tone of the map leaves a fifth of the paper, which closes in still darker ones.
  covered = mix(covered, 1.0, clamp(1.0 - tone / 0.2, 0.0, 1.0));
  vec4 drawn = mix(paperColor, vec4(ink, inkColor.a), clamp(covered, 0.0, 1.0));
  return vec4(drawn.rgb, drawn.a * s.color.a);
}
