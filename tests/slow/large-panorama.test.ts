import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

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
