import { readdirSync } from 'node:fs';
import { expect, test } from '@jest/globals';
import { openModule, useBrowser } from '../support/browser.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Counts, Way } from './depth-filters.page.ts';

const chromium = useBrowser();
/** Every so many-th frame of the recording. */
const STRIDE = 12;

describeWithData('occlusion by a coarse and noisy sensor', 'sessions/icl-livingroom', (recording) => {
  test('is the better the more its filter knows: nearest, linear, edge-aware', async () => {
    const page = await openModule(chromium.browser, 'tests/slow/depth-filters.page.ts', { mounts: { '/recording/': recording } });
    const [depths, colors] = ['depth', 'color'].map((folder) => readdirSync(`${recording}/${folder}`).sort());
    const total = new Map<string, Counts>();
    for (let i = 0; i < (depths?.length ?? 0); i += STRIDE) {
      const found = await page.call<Record<Way, Counts>>(
        'compare',
        `/recording/depth/${depths?.[i]}`,
        `/recording/color/${colors?.[i]}`,
        i,
      );
      for (const [way, counts] of Object.entries(found)) total.set(way, sum(total.get(way), counts));
    }
    await page.close();
    expect(page.errors).toEqual([]);

    const scores = new Map([...total].map(([way, c]) => [way, { shown: c.shown / c.shownEver, hidden: c.hidden / c.hiddenEver }]));
    console.info(
      [
        'IoU within 3 px of the true border, 160 × 90 samples, σ = 1 cm + 0.5 %:   shown   hidden',
        ...[...scores].map(([way, { shown, hidden }]) => `${way.padEnd(72)}  ${shown.toFixed(4)}  ${hidden.toFixed(4)}`),
      ].join('\n'),
    );
    const of = (way: Way) => scores.get(way) ?? { shown: 0, hidden: 0 };
    for (const what of ['shown', 'hidden'] as const) {
      expect(of('nearest')[what]).toBeGreaterThan(0.5);
      expect(of('linear')[what]).toBeGreaterThan(of('nearest')[what]);
      expect(of('edge-aware without camera')[what]).toBeGreaterThan(of('linear')[what]);
      expect(of('edge-aware')[what]).toBeGreaterThan(of('linear')[what] + 0.04);
    }
  });
});

function sum(a: Counts | undefined, b: Counts): Counts {
  if (!a) return b;
  return {
    shown: a.shown + b.shown,
    shownEver: a.shownEver + b.shownEver,
    hidden: a.hidden + b.hidden,
    hiddenEver: a.hiddenEver + b.hiddenEver,
  };
}
