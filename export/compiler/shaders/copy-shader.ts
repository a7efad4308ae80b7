/** Copies a layer unchanged, for layers that no other pass draws to the screen. */
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
