/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Grayscale",
  "DESCRIPTION": "Converts an image to shades of gray of the same brightness.",
  "CREDIT": "Scrim. Luma: Rec. ITU-R BT.709",
  "CATEGORIES": ["Color", "Black and white", "Gray", "Grey", "Desaturate", "Monochrome", "BW"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to convert." },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "0 leaves the colors unchanged, 1 removes them.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(mix(color.rgb, vec3(dot(color.rgb, LUMA_709)), amount), color.a);
}
