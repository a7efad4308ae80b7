import { expect, test } from '@jest/globals';
import type { ViewFrame } from '../../nodes/kit/session.ts';
import { createThumbnails } from './thumbnails.ts';

type Player = Parameters<ReturnType<typeof createThumbnails>['afterFrame']>[0];

/** A frame that is shown repeatedly. */
const STILL = { timeS: 0, framebufferWidthPx: 640, framebufferHeightPx: 480, views: [] };

function playFrame(thumbnails: ReturnType<typeof createThumbnails>, player: Player): number | null {
  thumbnails.beforeFrame(STILL);
  return thumbnails.afterFrame(player);
}

test('layers are read in turn, and reading takes a tenth of the time at most; while held, each is read once more when something changed', () => {
  let nowS = 0;
  const read: [string, number][] = [];
  const thumbnails = createThumbnails({ nowS: () => nowS }, () => {});
  const player = {
    // Reading takes 5 ms, and gives nothing where nothing is tapped yet.
    inspect: (layer: string | null) => {
      read.push([layer ?? '', Math.round(nowS * 1000)]);
      nowS += 0.005;
      return null;
    },
  };
  const frames = (until: number, more: boolean[] = []) => {
    for (; nowS < until; nowS += 1 / 60) more.push(playFrame(thumbnails, player) !== null);
    return more;
  };
  frames(0.1);
  expect(read).toEqual([]);
  thumbnails.setPorts([...'abcdefgh'], 96);
  const more = frames(1.1);
  expect(read.map(([layer]) => layer).slice(0, 11)).toEqual([...'abcdefgh', ...'bcd']);
  expect(read.length * 0.005).toBeLessThanOrEqual(0.1 + 6 * 0.005);
  expect(read.length).toBeGreaterThan(10);
  // Until all were read, a held preview has to go on.
  expect(more.indexOf(false)).toBeGreaterThan(2);
  expect(more.at(-1)).toBe(false);
  thumbnails.invalidate();
  expect(playFrame(thumbnails, player)).toBeGreaterThan(0);
});

/** Thumbnails whose reads take `readS` seconds and are noted with the time of each. The clock is set by the test. */
function readThumbnails(readS: number) {
  Object.assign(globalThis, { ImageData: class {}, createImageBitmap: () => new Promise(() => {}) });
  const clock = { timeS: 0 };
  const read: number[] = [];
  const thumbnails = createThumbnails(
    { nowS: () => clock.timeS },
    () => {},
    () => {
      read.push(clock.timeS);
      clock.timeS += readS;
      return { widthPx: 1, heightPx: 1, pixels: new Uint8Array(4) };
    },
  );
  return { clock, read, thumbnails };
}

test('while changes follow each other, what was seen before waits for a pause; what was not is read at once', () => {
  const { clock, read, thumbnails } = readThumbnails(0);
  const player = { inspect: () => null };
  thumbnails.setPorts(['a'], 96);
  thumbnails.invalidateAfterPause();
  expect([playFrame(thumbnails, player), read]).toEqual([null, [0]]);
  for (const keyS of [1, 1.2, 1.4]) {
    clock.timeS = keyS;
    thumbnails.invalidateAfterPause();
    expect(playFrame(thumbnails, player)).toBeCloseTo(0.25);
  }
  expect(read).toEqual([0]);
  clock.timeS = 1.66;
  playFrame(thumbnails, player);
  expect(read).toEqual([0, 1.66]);
});

test('what has not been seen yet is read sooner', () => {
  const { clock, read, thumbnails } = readThumbnails(0.3);
  thumbnails.setPorts([...'abcdefgh'], 96);
  for (; read.length < 10; clock.timeS += 1 / 60) playFrame(thumbnails, { inspect: () => null });
  // Six in one frame, the rest after a rest that is as long as reading took; then one in a tenth of the time.
  expect(read.slice(0, 6).map((timeS) => Math.round(timeS * 10))).toEqual([0, 3, 6, 9, 12, 15]);
  expect(read.slice(6, 9).map((timeS) => Math.round(timeS * 10))).toEqual([36, 39, 48]);
  expect((read[9] ?? 0) - (read[8] ?? 0)).toBeGreaterThanOrEqual(3);
});

test('a layer is read ten times per second at most, and drawn only in the frames that read it', () => {
  const { clock, read, thumbnails } = readThumbnails(0);
  thumbnails.setPorts(['a', 'b'], 96);
  const drawn: string[] = [];
  for (; clock.timeS < 1; clock.timeS += 1 / 60) {
    drawn.push(...thumbnails.beforeFrame(STILL));
    thumbnails.afterFrame({ inspect: () => null });
  }
  expect(drawn.filter((port) => port === 'a').length).toBeLessThanOrEqual(10);
  expect(drawn.filter((port) => port === 'a').length).toBeGreaterThanOrEqual(8);
  expect(drawn).toHaveLength(read.length);
});

test('while held, a frame of another time, size or pose is shown by all layers', () => {
  const { clock, read, thumbnails } = readThumbnails(0);
  const view = { worldFromView: new Float32Array(16) } as ViewFrame;
  let frame = { ...STILL, views: [view] };
  /** Number of layers that are read until the preview rests. */
  const readUntilRest = () => {
    const before = read.length;
    for (let restS: number | null = 0; restS !== null; clock.timeS += Math.max(restS ?? 0, 1 / 60)) {
      thumbnails.beforeFrame(frame);
      restS = thumbnails.afterFrame({ inspect: () => null });
    }
    return read.length - before;
  };
  thumbnails.setPorts([...'abc'], 96);
  expect(readUntilRest()).toBe(3);
  for (const other of [{ timeS: 1 }, { framebufferWidthPx: 360 }, { views: [{ ...view, worldFromView: new Float32Array(16).fill(1) }] }]) {
    frame = { ...frame, ...other };
    expect(readUntilRest()).toBeGreaterThanOrEqual(3);
  }
});
