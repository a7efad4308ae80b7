/** Shows a layer as it is. Lays those onto the screen that are drawn nowhere else on their way to it. */
export const COPY_FILE = 'scrim/copy.fs';

export const COPY_SOURCE = `/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Shows a layer as it is.",
  "SCRIM_ALPHA": "premultiplied",
  "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }]
}*/

void main() {
  gl_FragColor = IMG_THIS_PIXEL(inputImage);
}
`;
