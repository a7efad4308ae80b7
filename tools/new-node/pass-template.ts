import type { Template } from './template.ts';

/** Template of a node that draws a layer with an ISF shader in its folder. */
export const PASS_TEMPLATE: Template = {
  definition: (type, title) => ({
    type,
    version: 1,
    title,
    doc: 'Tints the far parts of a layer, by its depth.',
    keywords: ['tint', 'distance'],
    inputs: { layer: { type: 'layer', label: 'Layer', doc: 'The layer to tint, with depth.', required: true } },
    outputs: { layer: { type: 'layer', label: 'Layer', doc: 'The tinted layer.', domain: 'view', depth: false } },
    params: {
      tint: { type: 'color', stage: 'uniform', label: 'Tint', doc: 'Color of the far parts.', default: [0.2, 0.4, 1, 1] },
      farM: {
        type: 'number',
        stage: 'uniform',
        label: 'Distance',
        doc: 'Distance from the camera at which the tint has its full strength.',
        default: 3,
        min: 0.1,
        max: 20,
        unit: 'm',
      },
    },
    lowering: { kind: 'image', shader: `${type}/${type.slice(type.indexOf('/') + 1)}.fs`, access: 'pointwise' },
  }),
  files: (_type, name) => ({
    [`${name}.fs`]: `/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Tints the far parts of a layer, by its depth.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Depth"],
  "SCRIM_DEPTH": "none",
  "INPUTS": [
    { "NAME": "layer", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to tint, with depth." },
    { "NAME": "tint", "TYPE": "color", "DEFAULT": [0.2, 0.4, 1.0, 1.0] },
    { "NAME": "farM", "TYPE": "float", "MIN": 0.1, "MAX": 20.0, "DEFAULT": 3.0, "UNIT": "m" }
  ]
}*/

void main() {
  vec4 color = IMG_THIS_PIXEL(layer);
  // Meters along the view axis; 0 where the depth is unknown.
  float amount = clamp(LAYER_DEPTH(layer, isf_FragNormCoord) / farM, 0.0, 1.0);
  gl_FragColor = vec4(mix(color.rgb, tint.rgb, amount * tint.a), color.a);
}
`,
    [`${name}.test.ts`]: `import { test } from '@jest/globals';
import { expectSpeaksFor } from '../../../tests/support/shader-definition.ts';
import { definition } from './definition.ts';

test('the definition agrees with the header of the shader: ports, params and cost', () => {
  expectSpeaksFor(definition, new URL('./${name}.fs', import.meta.url));
});
`,
  }),
};
