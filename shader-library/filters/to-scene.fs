/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "To scene",
  "DESCRIPTION": "Makes a scene layer of a display layer: linear light, which later effects can brighten beyond white. Use it to put a camera video or an image under a scene layer.",
  "CREDIT": "Scrim. Transfer function: IEC 61966-2-1",
  "CATEGORIES": ["Light", "HDR", "Linear", "Convert", "Encoding", "Color space"],
  "SCRIM_ENCODING": "display to scene",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The display layer to convert." }
  ]
}*/

// Linear light from display-referred sRGB (IEC 61966-2-1), per channel.
vec3 linearFromDisplay(vec3 color) {
  return mix(pow((color + 0.055) / 1.055, vec3(2.4)), color / 12.92, vec3(lessThanEqual(color, vec3(0.04045))));
}

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(linearFromDisplay(color.rgb), color.a);
}
