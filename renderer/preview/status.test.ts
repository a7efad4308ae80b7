import { expect, test } from '@jest/globals';
import { createSessionFrame } from '../../export/runtime/sessions/session-frame.ts';
import type { FromPreview } from '../preview-protocol.ts';
import { createStatus } from './status.ts';

test('the frame rate is that of the last half second while time passes, and unknown while it does not', () => {
  let nowS = 0;
  const sent: FromPreview[] = [];
  const clock = { nowS: () => nowS } as Parameters<typeof createStatus>[0];
  const status = createStatus(clock, (message) => void sent.push(message));
  const frame = createSessionFrame();
  const rate = () => {
    const last = sent.at(-1);
    return last?.kind === 'status' ? last.status.framesPerS : null;
  };
  const play = (untilS: number, framesPerS: number) => {
    for (; nowS < untilS; nowS += 1 / framesPerS) {
      status.begin();
      status.end(frame, false);
    }
  };
  status.setState('playing');
  expect(rate()).toBe(0);
  play(2, 30);
  expect(rate()).toBeCloseTo(30, 0);
  play(4, 12);
  expect(rate()).toBeCloseTo(12, 0);
  status.setState('paused');
  expect(rate()).toBe(0);
});
