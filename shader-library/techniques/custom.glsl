/*{
  "DESCRIPTION": "A template for your own material: it shades the object's color in bands of light and shows what a custom material can use. Open its code and edit it; the project then gets its own copy.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Custom", "Template", "Own", "New", "Shader", "GLSL", "Code"],
  "INPUTS": [
    { "NAME": "tint", "TYPE": "color", "LABEL": "Tint", "DOC": "Color of the rim.", "DEFAULT": [0.3, 0.75, 1.0, 1.0] },
    { "NAME": "rim", "TYPE": "float", "LABEL": "Rim", "DOC": "Width of the rim.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.35, "UNIT": "ratio" },
    { "NAME": "wave", "TYPE": "float", "LABEL": "Wave", "DOC": "Amplitude of the movement of the surface.", "MIN": 0.0, "MAX": 0.05, "DEFAULT": 0.0, "IDENTITY": 0.0, "UNIT": "m" },
    { "NAME": "picture", "TYPE": "image", "LABEL": "Image", "DOC": "A layer that is projected onto the object from the view.", "OPTIONAL": true }
  ]
}*/
#include <light/diffuse>

// Moves the vertices of the object. Optional.
void vertex(inout Vertex v) {
  v.position += v.normal * (wave * sin(TIME * 2.0 + v.rest.y * 20.0));
}

// Returns the color of a visible point: red, green and blue in linear light, and opacity.
vec4 surface(const in Surface s) {
  vec3 light = diffuseLight(s.normal);
  vec3 color = s.color.rgb * light;
  vec4 layer = IMG_THIS_PIXEL(picture);
  color = mix(color, layer.rgb, layer.a * 0.5);
  float edge = 1.0 - dot(s.normal, s.towardsEye);
  color = mix(color, tint.rgb * light, smoothstep(1.0 - rim, 1.0, edge) * tint.a);
  return vec4(color, s.color.a);
}
