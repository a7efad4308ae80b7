import type { GraphText } from './open-editor.ts';

/** A filter with an input, a function and two literals. */
export const TINT_SHADER = `/*{
  "ISFVSN": "2",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer" },
    { "NAME": "share", "TYPE": "float", "LABEL": "Share", "DOC": "How much of the tint.", "MIN": 0, "MAX": 1, "DEFAULT": 1 }
  ]
}*/
// Paints it over.
vec3 paint(vec3 color, float much) {
  return mix(color, vec3(0.1, 0.2, 0.9), much);
}
void main() {
  vec4 pixel = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(paint(pixel.rgb, share * 0.50), pixel.a);
}
`;

/** The camera feed with a filter of the project, whose amount is connected to a number. */
export const TINTED: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'number-aaaa': { type: 'value/number', params: { value: 1 } },
    'tint-aaaa': { type: 'filter/tint', params: { share: { port: 1 } } },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> tint-aaaa.inputImage', 'number-aaaa.number -> tint-aaaa.share', 'tint-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'number-aaaa': [0, 140], 'tint-aaaa': [260, 0], 'screen-aaaa': [520, 0] },
  shaders: { 'tint.fs': TINT_SHADER },
};
