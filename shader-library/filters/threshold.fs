/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Turns the picture into two colors: one for what is darker than the level, one for what is lighter.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Color", "Style", "Black and white", "Binary", "BW"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to divide." },
    { "NAME": "level", "TYPE": "float", "LABEL": "Level", "DOC": "Brightness at which dark becomes light, as Rec. 709 luma from 0 to 1.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "softness", "TYPE": "float", "LABEL": "Softness", "DOC": "Width of the step from dark to light, around the level. 0 is a hard edge.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" },
    { "NAME": "darkColor", "TYPE": "color", "LABEL": "Dark", "DOC": "Color of what is darker.", "DEFAULT": [0.0, 0.0, 0.0, 1.0] },
    { "NAME": "lightColor", "TYPE": "color", "LABEL": "Light", "DOC": "Color of what is lighter, or just as light as the level.", "DEFAULT": [1.0, 1.0, 1.0, 1.0] }
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
