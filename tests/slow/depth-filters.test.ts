import { mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { openModule, useBrowser } from '../support/browser.ts';
import { encodeImage, fromGl } from '../support/image.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Counts, Panel, Way } from './depth-filters.page.ts';
import { drawScan } from './draw-scan.ts';

const chromium = useBrowser();
/** Of the recording; in 39, walls meet at corners. */
const FRAMES = [0, 26, 39];

const SENSORS = {
  exact: {},
  'σ = 1 cm + 0.5 %': { sigmaM: 0.01, sigmaPerM: 0.005 },
  'σ = 2 cm + 1 %, 5 % holes': { sigmaM: 0.02, sigmaPerM: 0.01, holes: 0.05 },
} as const;

describeWithData('occlusion by a coarse and noisy sensor', 'sessions/icl-livingroom', (recording) => {
  test.each(Object.entries(SENSORS))('is never worse by edges than by linear interpolation: %s', async (name, noise) => {
    const page = await openModule(chromium.browser, 'tests/slow/depth-filters.page.ts', { mounts: { '/recording/': recording } });
    const [depths, colors] = ['depth', 'color'].map((folder) => readdirSync(`${recording}/${folder}`).sort());
    const total = new Map<string, Counts>();
    for (const i of FRAMES) {
      const found = await page.call<Record<Way, Counts>>('compare', `/recording/depth/${depths?.[i]}`, `/recording/color/${colors?.[i]}`, {
        ...noise,
        seed: i,
      });
      for (const [way, counts] of Object.entries(found)) {
        total.set(way, sum(total.get(way), counts));
        if (!way.startsWith('edge-aware')) continue;
        expect([i, way, counts.near + counts.far < found.linear.near + found.linear.far]).toEqual([i, way, true]);
        expect([i, way, counts.far <= found.linear.far]).toEqual([i, way, true]);
      }
    }
    await page.close();
    expect(page.errors).toEqual([]);
    const share = (counts: Counts): [shown: number, hidden: number] => [counts.shown / counts.shownEver, counts.hidden / counts.hiddenEver];
    console.info(
      [
        `160 × 120 samples, ${name}: IoU of shown and hidden within 3 px of the border; wrong pixels there and beyond`,
        ...[...total].map(([way, counts]) => {
          const [shown, hidden] = share(counts);
          return `${way.padEnd(28)} ${shown.toFixed(3)} ${hidden.toFixed(3)} ${String(counts.near).padStart(7)} ${String(counts.far).padStart(7)}`;
        }),
      ].join('\n'),
    );
    const of = (way: Way): Counts => total.get(way) as Counts;
    for (const what of [0, 1]) {
      expect(share(of('edge-aware without camera'))[what]).toBeGreaterThan(share(of('linear'))[what] ?? 1);
      expect(share(of('edge-aware'))[what]).toBeGreaterThan((share(of('edge-aware without camera'))[what] ?? 1) + 0.005);
    }
    expect(of('by sensor')).toEqual(of('edge-aware without camera'));
    // An image whose edges are elsewhere is left out.
    expect(of('edge-aware, camera shifted')).toEqual(of('edge-aware without camera'));
  });

  test('shows a panel before the window, behind its frame', async () => {
    const page = await openModule(chromium.browser, 'tests/slow/depth-filters.page.ts', { mounts: { '/recording/': recording } });
    const [depth, color] = ['depth', 'color'].map((folder) => `/recording/${folder}/${readdirSync(`${recording}/${folder}`).sort()[59]}`);
    // Curtain and mullion are 1.8 m to 2 m away, the balcony behind the glass 2.6 m to 3.1 m.
    const found = await page.call<Panel>('hiddenPanel', depth, color, 2.3);
    await page.close();
    mkdirSync('tests/output/depth', { recursive: true });
    writeFileSync('tests/output/depth/window.png', encodeImage(fromGl(320, 240, found.seen)));
    console.info(`A panel at 2.3 m before the window: ${(found.filled * 100).toFixed(1)} % of its ${found.holes} pixels are hidden.`);
    expect(page.errors).toEqual([]);
    expect(found.holes).toBeGreaterThan(20_000);
    // The rest is at the edge of the glass, where samples of the frame are interpolated.
    expect(found.filled).toBeLessThan(0.06);
    expect(found.filled - found.unfilled).toBeLessThan(0.02);
  });
});

describe('occlusion in the emulator’s scanned rooms', () => {
  test.each(['living_room', 'office_small'])('is never worse by sensor than by linear interpolation: %s', async (name) => {
    const folder = mkdtempSync(join(tmpdir(), 'scrim-depth-'));
    const view = drawScan(name, folder);
    const page = await openModule(chromium.browser, 'tests/slow/depth-filters.page.ts', { mounts: { '/scan/': folder } });
    const lines: string[] = [];
    const worse: string[] = [];
    for (const [sensor, noise] of Object.entries(SENSORS)) {
      // Real sensors have noise. Without any, views with few borders may have some more wrong pixels.
      if (noise === SENSORS.exact) continue;
      const found = await page.call<Record<Way, Counts>>('compare', `/scan/${view}`, null, { ...noise, seed: 5 });
      const [ours, linear] = [found['by sensor'], found.linear];
      lines.push(`${name} ${sensor}: ${ours.near} + ${ours.far} wrong pixels, linear ${linear.near} + ${linear.far}`);
      if (ours.near + ours.far > linear.near + linear.far || ours.far > linear.far) worse.push(sensor);
    }
    await page.close();
    rmSync(folder, { recursive: true });
    console.info(lines.join('\n'));
    expect(worse).toEqual([]);
    expect(page.errors).toEqual([]);
  });
});

function sum(a: Counts | undefined, b: Counts): Counts {
  if (!a) return b;
  const keys = Object.keys(b) as (keyof Counts)[];
  return Object.fromEntries(keys.map((key) => [key, a[key] + b[key]])) as unknown as Counts;
}
