import { expect, test } from '@jest/globals';
import { importCaptureCommand } from '../commands/import-capture.ts';
import { parseCall } from '../parse-call.ts';
import { readKnownSize } from './known-size.ts';

const call = (...args: string[]) => parseCall(importCaptureCommand, ['folder', '--project', 'p', ...args]);

test('reads the known distance and the floor, also of names with colons', () => {
  expect(readKnownSize(call('--distance', 'rig/a:1.jpg:310,842.5:1490,830=2.1', '--floor', 'a.jpg:900,1400'))).toEqual({
    distance: {
      from: { photo: 'rig/a:1.jpg', column: 310, row: 842.5 },
      to: { photo: 'rig/a:1.jpg', column: 1490, row: 830 },
      meters: 2.1,
    },
    floor: { photo: 'a.jpg', column: 900, row: 1400 },
    cameraHeightM: null,
  });
});

test.each([
  [['--distance', 'a.jpg:1,2=3'], /--distance needs a photograph, two places and meters/],
  [['--distance', 'a.jpg:1,2:3,4=0'], /--distance needs/],
  [['--floor', 'a.jpg'], /--floor needs a photograph and a place/],
  [['--camera-height', '1.5'], /--camera-height needs --floor/],
  [['--camera-height', 'high', '--floor', 'a.jpg:1,2'], /needs a number of meters above 0/],
  [['--unit', '2', '--distance', 'a.jpg:1,2:3,4=1'], /--unit and --distance exclude each other/],
])('%j is refused', (args, message) => {
  expect(() => readKnownSize(call(...args))).toThrow(message);
});
