import { expect, test } from '@jest/globals';
import { chain, twins } from '../../tests/support/fusion-kit.ts';
import { frameTraffic } from './frame-traffic.ts';

const SIZE = { widthPx: 10, heightPx: 5 } as const;
const LAYER_BYTES = 10 * 5 * 4;
const NO_DRAWS = { draws: 0, drawnBytes: 0, resolvedBytes: 0 };

test('counts the layers that passes read and write, and textures that targets share once', () => {
  const { separate, fused } = chain(['filter/sepia', 'filter/vignette', 'filter/grey']);
  expect(frameTraffic(separate, SIZE)).toEqual({
    passes: 4,
    targets: 2,
    targetBytes: 2 * LAYER_BYTES,
    readBytes: 3 * LAYER_BYTES,
    writtenBytes: 4 * LAYER_BYTES,
    ...NO_DRAWS,
  });
  expect(frameTraffic(fused, SIZE)).toEqual({
    passes: 1,
    targets: 0,
    targetBytes: 0,
    readBytes: 0,
    writtenBytes: LAYER_BYTES,
    ...NO_DRAWS,
  });
});

/** Four samples of color and depth, and the texture that they are resolved to. */
const DRAWN_BYTES = 10 * 5 * (4 * (4 + 4) + 4);
const RESOLVED_BYTES = 10 * 5 * 4 * 4;

const SCENE = {
  'box-a': { type: 'objects/primitive', version: 1 },
  'scene-a': { type: 'layer/scene', version: 1 },
  'screen-a': { type: 'output/screen', version: 1 },
};

test('counts what objects write to the screen, and what is read to resolve its samples', () => {
  const { fused } = twins(SCENE, ['box-a.objects -> scene-a.objects', 'scene-a.layer -> screen-a.layer']);
  expect(frameTraffic(fused, SIZE)).toMatchObject({ passes: 0, draws: 1, drawnBytes: DRAWN_BYTES, resolvedBytes: RESOLVED_BYTES });
});

test('counts what objects write to a layer, and the depth that an effect reads of it', () => {
  const nodes = { ...SCENE, 'fog-a': { type: 'filter/fog', version: 1 } };
  const wires = ['box-a.objects -> scene-a.objects', 'scene-a.layer -> fog-a.inputImage', 'fog-a.layer -> screen-a.layer'];
  const { fused } = twins(nodes, wires);
  expect(frameTraffic(fused, SIZE)).toMatchObject({
    passes: 1,
    readBytes: 2 * LAYER_BYTES,
    draws: 1,
    // The depth is resolved, too.
    drawnBytes: DRAWN_BYTES + LAYER_BYTES,
    resolvedBytes: 2 * RESOLVED_BYTES,
  });
});
