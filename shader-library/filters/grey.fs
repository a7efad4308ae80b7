/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Takes the colour out of the picture and leaves its brightness: shades of grey.",
  "CREDIT": "Scrim. Luma: Rec. ITU-R BT.709",
  "CATEGORIES": ["Colour", "Black and white", "Gray", "Desaturate", "Monochrome", "BW"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to turn grey." },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "0 leaves the colours as they are, 1 leaves none.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(mix(color.rgb, vec3(dot(color.rgb, LUMA_709)), amount), color.a);
}
