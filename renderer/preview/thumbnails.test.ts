import { expect, test } from '@jest/globals';
import { createThumbnails } from './thumbnails.ts';

type Player = Parameters<ReturnType<typeof createThumbnails>['afterFrame']>[0];

function playFrame(thumbnails: ReturnType<typeof createThumbnails>, player: Player): number | null {
  thumbnails.beforeFrame();
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
  thumbnails.setPorts(['a', 'b', 'c'], 96);
  const more = frames(1.1);
  expect(read.map(([layer]) => layer).slice(0, 4)).toEqual(['b', 'c', 'a', 'b']);
  expect(read.length * 0.005).toBeLessThanOrEqual(0.1);
  expect(read.length).toBeGreaterThan(10);
  // Until all three were read, a held preview has to go on.
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
  thumbnails.setPorts(['a', 'b', 'c'], 96);
  for (; read.length < 5; clock.timeS += 1 / 60) playFrame(thumbnails, { inspect: () => null });
  const [a = 0, b = 0, c = 0, again = 0, later = 0] = read;
  // Each as long as reading takes apart; then in a tenth of the time.
  expect([b - a, c - b, again - c].map((apartS) => Math.round(apartS * 10))).toEqual([6, 6, 6]);
  expect(later - again).toBeGreaterThanOrEqual(3);
});

test('a layer is read ten times per second at most, and drawn only in the frames that read it', () => {
  const { clock, read, thumbnails } = readThumbnails(0);
  thumbnails.setPorts(['a', 'b'], 96);
  const drawn: (string | null)[] = [];
  for (; clock.timeS < 1; clock.timeS += 1 / 60) {
    drawn.push(thumbnails.beforeFrame());
    thumbnails.afterFrame({ inspect: () => null });
  }
  expect(drawn.filter((port) => port === 'a').length).toBeLessThanOrEqual(10);
  expect(drawn.filter((port) => port === 'a').length).toBeGreaterThanOrEqual(8);
  expect(drawn.filter((port) => port !== null)).toHaveLength(read.length);
});
