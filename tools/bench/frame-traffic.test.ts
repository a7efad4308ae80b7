import { expect, test } from '@jest/globals';
import { chain } from '../../tests/support/fusion-kit.ts';
import { frameTraffic } from './frame-traffic.ts';

const SIZE = { widthPx: 10, heightPx: 5 } as const;
const LAYER_BYTES = 10 * 5 * 4;

test('counts the layers that passes read and write, and textures that targets share once', () => {
  const { separate, fused } = chain(['filter/sepia', 'filter/vignette', 'filter/grey']);
  expect(frameTraffic(separate, SIZE)).toEqual({
    passes: 4,
    targets: 2,
    targetBytes: 2 * LAYER_BYTES,
    readBytes: 3 * LAYER_BYTES,
    writtenBytes: 4 * LAYER_BYTES,
  });
  expect(frameTraffic(fused, SIZE)).toEqual({ passes: 1, targets: 0, targetBytes: 0, readBytes: 0, writtenBytes: LAYER_BYTES });
});
