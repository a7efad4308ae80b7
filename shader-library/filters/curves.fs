/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Maps tones with curves: the horizontal axis is the input, the vertical axis the output. An S-shaped curve adds contrast; an arched curve brightens or darkens and keeps black and white.",
  "CREDIT": "Scrim. Order of the curves: Blender's RGB Curves. Between points: F. N. Fritsch, R. E. Carlson 1980, SIAM J. Numer. Anal. 17, 238",
  "CATEGORIES": ["Color", "Tone", "Levels", "Contrast", "Grading", "Gradation", "RGB curves"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to grade." },
    { "NAME": "all", "TYPE": "curve", "LABEL": "All channels", "DOC": "Curve for red, green and blue. Applied before the curves below." },
    { "NAME": "red", "TYPE": "curve", "LABEL": "Red", "DOC": "Curve for red." },
    { "NAME": "green", "TYPE": "curve", "LABEL": "Green", "DOC": "Curve for green." },
    { "NAME": "blue", "TYPE": "curve", "LABEL": "Blue", "DOC": "Curve for blue." },
    { "NAME": "luma", "TYPE": "curve", "LABEL": "Brightness", "DOC": "Curve for brightness, which keeps the hue. Applied after the curves above." },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "Strength of the effect: 0 leaves the image unchanged.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  vec3 graded = color.rgb;
  // Other hosts do not support curves and show the layer unchanged.
#ifdef SCRIM
  graded = vec3(CURVE(red, CURVE(all, graded.r)), CURVE(green, CURVE(all, graded.g)), CURVE(blue, CURVE(all, graded.b)));
  float bright = dot(graded, LUMA_709);
  graded += CURVE(luma, bright) - bright;
#endif
  gl_FragColor = vec4(mix(color.rgb, graded, amount), color.a);
}
