/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Brightness/contrast",
  "DESCRIPTION": "Changes brightness, contrast and midtones; the color differences stay the same.",
  "CREDIT": "Scrim. Luma: Rec. ITU-R BT.709. Effect named in the mixed-reality rendering framework with osgART, figure 14",
  "CATEGORIES": ["Color", "Light", "Luminance variation", "Brightness", "Contrast", "Gamma", "Color correction"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to change." },
    { "NAME": "brightness", "TYPE": "float", "LABEL": "Brightness", "DOC": "Added to the luma: -1 gives black, 1 gives white.", "MIN": -1.0, "MAX": 1.0, "DEFAULT": 0.0, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "contrast", "TYPE": "float", "LABEL": "Contrast", "DOC": "Factor on the difference from middle gray: 0 gives the same luma everywhere, 2 doubles the contrast.", "MIN": 0.0, "MAX": 4.0, "DEFAULT": 1.4, "IDENTITY": 1.0, "UNIT": "ratio" },
    { "NAME": "gamma", "TYPE": "float", "LABEL": "Midtones", "DOC": "Above 1 the midtones become lighter, below 1 darker. Black and white do not change.", "MIN": 0.2, "MAX": 5.0, "DEFAULT": 1.0, "IDENTITY": 1.0, "UNIT": "ratio" }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);
const float MIDDLE = 0.5;

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float luma = dot(color.rgb, LUMA_709);
  float varied = pow(clamp(luma, 0.0, 1.0), 1.0 / gamma);
  varied = clamp((varied - MIDDLE) * contrast + MIDDLE + brightness, 0.0, 1.0);
  // Red, green and blue change by the same amount, so Cb and Cr, the differences to the luma, do not change.
  gl_FragColor = vec4(color.rgb + (varied - luma), color.a);
}
