/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Hue/saturation",
  "DESCRIPTION": "Changes saturation and hue, or shifts colors along two axes; the brightness stays the same.",
  "CREDIT": "Scrim. Color differences: Rec. ITU-R BT.709. Effect named in the mixed-reality rendering framework with osgART, figure 14",
  "CATEGORIES": ["Color", "Chrominance variation", "Saturation", "Hue", "Tint"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to recolor." },
    { "NAME": "saturation", "TYPE": "float", "LABEL": "Saturation", "DOC": "Factor on the saturation: 0 gives gray, 2 doubles it.", "MIN": 0.0, "MAX": 4.0, "DEFAULT": 1.0, "IDENTITY": 1.0, "UNIT": "ratio" },
    { "NAME": "rotation", "TYPE": "float", "LABEL": "Hue", "DOC": "Rotates all hues around the color wheel, from blue towards red.", "MIN": -3.14159265, "MAX": 3.14159265, "DEFAULT": 1.0471976, "IDENTITY": 0.0, "UNIT": "rad" },
    { "NAME": "blueYellow", "TYPE": "float", "LABEL": "Yellow to blue", "DOC": "Shifts every color towards blue, or towards yellow below 0.", "MIN": -0.5, "MAX": 0.5, "DEFAULT": 0.0, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "redCyan", "TYPE": "float", "LABEL": "Cyan to red", "DOC": "Shifts every color towards red, or towards cyan below 0.", "MIN": -0.5, "MAX": 0.5, "DEFAULT": 0.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// Cb = (B - Y) / 2 (1 - kb) and Cr = (R - Y) / 2 (1 - kr), both in [-0.5, 0.5].
const vec2 RANGE = vec2(1.8556, 1.5748);

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float luma = dot(color.rgb, LUMA_709);
  vec2 chroma = (color.br - luma) / RANGE;
  float c = cos(rotation);
  float s = sin(rotation);
  chroma = saturation * vec2(c * chroma.x - s * chroma.y, s * chroma.x + c * chroma.y) + vec2(blueYellow, redCyan);
  vec2 blueRed = luma + chroma * RANGE;
  float green = (luma - LUMA_709.b * blueRed.x - LUMA_709.r * blueRed.y) / LUMA_709.g;
  gl_FragColor = vec4(blueRed.y, green, blueRed.x, color.a);
}
