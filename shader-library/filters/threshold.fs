/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Reduces an image to two colors: one for areas darker than the level, one for lighter areas.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Color", "Style", "Black and white", "Binary", "BW"],
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to threshold." },
    { "NAME": "level", "TYPE": "float", "LABEL": "Level", "DOC": "Brightness that separates dark from light: Rec. 709 luma, from 0 to 1.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "softness", "TYPE": "float", "LABEL": "Softness", "DOC": "Width of the transition around the level. 0 gives a hard edge.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" },
    { "NAME": "darkColor", "TYPE": "color", "LABEL": "Dark", "DOC": "Color of the darker areas.", "DEFAULT": [0.0, 0.0, 0.0, 1.0] },
    { "NAME": "lightColor", "TYPE": "color", "LABEL": "Light", "DOC": "Color of the areas that are as light as the level or lighter.", "DEFAULT": [1.0, 1.0, 1.0, 1.0] }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float luma = dot(color.rgb, LUMA_709);
  float halfWidth = 0.5 * softness;
  float light = halfWidth > 0.0 ? smoothstep(level - halfWidth, level + halfWidth, luma) : step(level, luma);
  vec4 chosen = mix(darkColor, lightColor, light);
  gl_FragColor = vec4(chosen.rgb, chosen.a * color.a);
}
