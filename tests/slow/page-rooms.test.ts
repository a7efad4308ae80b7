import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { useBrowser } from '../support/browser.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';
import { roomBox } from '../xr/room-box.ts';
import { openXrPage, readCapture } from '../xr/xr-page.ts';
import { eyesOf, findPoses, HEIGHT, type Place, tally, WIDTH } from './room-rays.ts';

// A box and its shadow in each scanned room, as an exported page draws them on a phone and a headset.

const chromium = useBrowser();

/** Where the floor of each room is free around the box. */
const ROOMS: readonly (readonly [name: string, place: Place])[] = [
  ['office_small', [-0.4, 0.3]],
  ['meeting_room', [-1, 0.25]],
  ['office_large', [0, -0.2]],
  ['living_room', [0, 0.75]],
  ['music_room', [0, -0.4]],
];

const DEVICES: readonly (readonly [string, EmulatorOptions, number])[] = [
  ['one view', { device: 'phone', depth: { sizePx: [WIDTH, HEIGHT] } }, 1],
  ['two views', { device: 'headset', extra: ['light-estimation'], depth: { sizePx: [WIDTH / 2, HEIGHT] } }, 2],
];

describe.each(ROOMS)('in the scanned room %s', (name, place) => {
  let served: ServedExport;
  beforeAll(async () => {
    served = await serveProjectText(roomBox(...place), {});
  });
  afterAll(() => served?.close());

  test.each(DEVICES)('walls and furniture hide the box and its shadow, which falls away from the light: %s', async (_, options, views) => {
    const viewport = { width: WIDTH, height: HEIGHT };
    const xr = await openXrPage(
      chromium.browser,
      served.url,
      { room: await readCapture(name), sizePx: [WIDTH, HEIGHT], display: false, ...options },
      viewport,
    );
    await xr.enter();
    const sums: Record<string, number> = {};
    for (const matrix of await findPoses(xr, place)) {
      await xr.setPose({ matrix });
      await xr.step(2);
      const layer = await xr.readLayer();
      const eyes = await eyesOf(xr);
      expect(eyes).toHaveLength(views);
      for (const eye of eyes) {
        const { counts, wrong } = await tally(xr, place, eye, layer);
        expect(wrong).toEqual([]);
        for (const [kind, count] of Object.entries(counts)) sums[kind] = (sums[kind] ?? 0) + count;
      }
    }
    // Both were there to be seen, and something stood before them.
    for (const kind of ['box', 'shadow', 'lit floor', 'hidden']) expect([kind, (sums[kind] ?? 0) > 2]).toEqual([kind, true]);
    expect(xr.errors).toEqual([]);
    await xr.close();
  });
});
