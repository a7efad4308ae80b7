import { expect } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { holder } from './clause-tests.ts';

// The emulated headset against WebXR Layers (immersive-web.github.io/layers): what it shows of several layers, and what it refuses.

const holds = holder(useModule('tests/browser/webxr-layers.page.ts'));

for (const textureType of ['texture', 'texture-array'] as const) {
  const isArray = textureType === 'texture-array';
  for (const kind of ['quad', 'cylinder'] as const) {
    // A quad of 1 m at 2 m, of 4 m · tan(0.7) that 64 columns show. A cylinder's edges are at ±0.25 rad.
    const columns = (kind === 'quad' ? 1 / (4 * Math.tan(0.7)) : Math.tan(0.25) / Math.tan(0.7)) * 64;
    holds(
      `Layers §5, ${kind} and projection layers of ${textureType}`,
      'pictures',
      [
        [
          'each view has its part of the projection layer, with depth',
          'images',
          isArray
            ? [
                [0, 64, 0, true],
                [0, 64, 1, true],
              ]
            : [
                [0, 64, null, true],
                [64, 64, null, true],
              ],
        ],
        ['textures are as large as the picture, or an eye’s', 'sizes', isArray ? [64, 64, 2] : [128, 64, 1]],
        ['a layer wants to be drawn at first', 'redraw', true],
        ['and not again', 'redrawAfter', false],
        [
          'the left eye sees its image over the layer below',
          'left',
          [
            [0, 255, 0, 255],
            [255, 0, 0, 255],
          ],
        ],
        [
          'the right eye sees its own, premultiplied',
          'right',
          [
            [127, 0, 128, 255],
            [255, 0, 0, 255],
          ],
        ],
        ['it is as wide as it stands there', 'widths', [columns, columns].map((wide) => expect.closeTo(wide, -0.6))],
      ],
      kind,
      textureType,
    );
  }
}

holds('Layers §3.2, what a layer may say', 'ways', [
  ['its image as it is', 'plain', [0, 0, 128, 128]],
  ['in the viewer’s space it goes with the head', 'turned', [0, 0, 128, 128]],
  ['opacity', 'faint', [0, 0, 64, 64]],
  ['without its alpha', 'opaque', [0, 0, 128, 255]],
  ['opacity is at most 1', 'opacity', 1],
  ['from behind nothing is seen', 'behind', [0, 0, 0, 0]],
  ['nothing is left of a destroyed layer', 'destroyed', [0, 0, 0, 0]],
]);

holds('Layers §2 and §5, refusals', 'refusals', [
  ['one projection layer needs no feature, all else does', 'without', { quad: 'NotSupportedError', two: 'NotSupportedError', one: null }],
  ['a layer needs a space', 'noSpace', 'TypeError'],
  ['a layer needs a width', 'noWidth', 'TypeError'],
  ['a layer needs pixels', 'noPixels', 'TypeError'],
  ['the layout "default" is refused', 'default', 'TypeError'],
  ['formats that cannot be drawn into are refused', 'format', 'TypeError'],
  ['a central angle is at most a full turn', 'cylinder', 'TypeError'],
  ['the device has no cube layers', 'cube', 'NotSupportedError'],
  ['a layer can be listed once', 'twice', 'TypeError'],
  ['layers or a base layer', 'withBase', 'NotSupportedError'],
  ['of an ended session there are none', 'ended', 'InvalidStateError'],
]);
