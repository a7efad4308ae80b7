import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import type { Lit } from './large-panorama-light.page.ts';

const page = useModule('tests/slow/large-panorama.page.ts');

interface Decoded {
  readonly size: readonly number[];
  readonly lamp: number;
  readonly lampForSearch: number;
  readonly bright: number;
  readonly ms: number;
  readonly drawn: number;
  readonly all: number;
}

test('an EXR of 8192 × 4096 is decoded while the page goes on drawing, also for the search', async () => {
  const { ms, drawn, all, ...rest } = await page.call<Decoded>('decode');
  console.info(`Decoded in ${Math.round(ms)} ms, ${drawn} frames meanwhile, ${all - drawn} while it is decoded for the search.`);
  expect(rest).toEqual({ size: [8192, 4096], lamp: 40, lampForSearch: 40, bright: 1 });
  expect(drawn).toBeGreaterThan(10);
  expect(all - drawn).toBeGreaterThan(10);
});

test('one that is cut off is refused', async () => {
  expect(await page.call<string>('decodeCut')).toMatch(/^the file is damaged .*Export it again$/);
});

const light = useModule('tests/slow/large-panorama-light.page.ts');

test.each([
  ['halves', 4096, 2048],
  ['png', 3001, 1501],
] as const)(
  '%s of %i × %i are uploaded and filtered in small parts between frames, and look as those that are loaded at once',
  async (...panorama) => {
    const [kind, widthPx] = panorama;
    const { most, most2, ...rest } = await light.call<Lit>('light', ...panorama);
    for (const { turns, rows, levelPx, facePx } of [most, ...(most2 ? [most2] : [])]) {
      expect(rows * widthPx).toBeLessThanOrEqual(2 ** 20);
      expect(levelPx).toBeLessThan(2 ** 21);
      expect(facePx).toBeLessThan(2 ** 19);
      expect(turns).toBeGreaterThan(40);
    }
    expect(rest).toMatchObject({
      readyAtOnce: [true, kind === 'png'],
      whole: { pixels: 0 },
      filled: kind === 'png' ? { pixels: 0 } : null,
      errors: [0, 0],
    });
    // The lamp was visible.
    if (kind === 'png') expect(rest.lampGone).toBeGreaterThan(20);
  },
);
