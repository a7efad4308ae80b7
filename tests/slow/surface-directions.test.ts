import { mkdirSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { encodeImage, fromGl } from '../support/image.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Shot, Square, Tone } from './model-styles.page.ts';

/** Strokes of hatching against the form of what they are on; the pictures are kept in `tests/output/surface-directions`. */

const page = useModule('tests/slow/model-styles.page.ts', { mounts: { '/models/': resolve('../shared/data/models') } });

const OUTPUT = 'tests/output/surface-directions';
const BLACK = { linePx: 0, ownTone: 0, inkColor: [0, 0, 0, 1], paperColor: [1, 1, 1, 1] };
const around = (azimuthRad: number, awayM: number, more: Partial<Shot> = {}): Shot => ({
  widthPx: 960,
  heightPx: 720,
  eye: [awayM * Math.sin(azimuthRad), 0.5, awayM * Math.cos(azimuthRad)],
  target: [0, 0, 0],
  ...more,
});

async function strokesOf(file: string, values: object, shot: Shot): Promise<Square[]> {
  const all = await page.call<Square[]>('strokes', file, 'hatching', { ...BLACK, ...values }, shot);
  return all.filter(({ ink, coherence }) => ink > 0.02 && coherence > 0.2);
}

/** Degrees between two lines. */
function apart(a: number, b: number): number {
  const turns = (a - b) / Math.PI;
  return Math.abs(turns - Math.round(turns)) * 180;
}

const quantile = (values: readonly number[], part: number): number =>
  [...values].sort((a, b) => a - b)[Math.floor(values.length * part)] ?? 180;

/** Degrees between the strokes of squares that touch. */
function betweenNeighbors(squares: readonly Square[]): number[] {
  return squares.flatMap((a) =>
    squares.filter((b) => (b.x - a.x === 24 && b.y === a.y) || (b.y - a.y === 24 && b.x === a.x)).map((b) => apart(a.angle, b.angle)),
  );
}

describe('strokes along the curvature', () => {
  test('of a torus are the circles of its tube, where the eye may see that', async () => {
    const shot = around(0.3, 1.4);
    // Darker strokes cross.
    const found = (await strokesOf('torus', { brightness: -0.5 }, shot)).filter(({ ink }) => ink < 0.3);
    const wanted = await page.call<(number | null)[]>(
      'tubeAngles',
      found.map(({ x, y }) => [x, y]),
      shot,
    );
    const off = found.flatMap(({ angle }, i) => (wanted[i] == null ? [] : [apart(angle, wanted[i])]));
    expect(off.length).toBeGreaterThan(80);
    expect(quantile(off, 0.5)).toBeLessThan(8);
    expect(quantile(off, 0.9)).toBeLessThan(25);
  });
});

describe('tones of strokes', () => {
  test('can be told apart at 480 × 360: six steps of light on a torus are six of paper, in order', async () => {
    const shot = around(2.5, 1.4, { widthPx: 480, heightPx: 360 });
    const all = await page.call<Tone[]>('tones', 'torus', 'hatching', BLACK, shot, 12);
    all.sort((a, b) => a.shaded - b.shaded);
    const steps = Array.from({ length: 6 }, (_, i) => all.slice((i * all.length) / 6, ((i + 1) * all.length) / 6));
    const mean = (step: readonly Tone[], of: (tone: Tone) => number): number => step.reduce((sum, tone) => sum + of(tone), 0) / step.length;
    const paper = steps.map((step) => mean(step, ({ drawn }) => drawn));
    const light = steps.map((step) => mean(step, ({ shaded }) => shaded));
    expect(light[5]).toBeGreaterThan(4 * (light[0] ?? 1));
    paper.forEach((part, i) => {
      expect(Math.abs(part - (light[i] ?? 0))).toBeLessThan(0.05);
      if (i > 0) expect(part - (paper[i - 1] ?? 1)).toBeGreaterThan(0.6 * ((light[i] ?? 0) - (light[i - 1] ?? 0)));
    });
  });
});

describeWithData('strokes on models', 'models', () => {
  test.each(['Curvature', 'Level'] as const)(
    'of the fox by %s have no chevrons: they turn slowly from one place to the next',
    async (mapping) => {
      const shot = around(0.9, 1.9, { timeS: 0.3 });
      const values = { mapping: mapping === 'Level' ? 0 : 2, turn: 0 };
      const between = betweenNeighbors(await strokesOf('Fox.glb', values, shot));
      const jumps = between.filter((degrees) => degrees > 45).length / between.length;
      expect(between.length).toBeGreaterThan(80);
      expect(quantile(between, 0.5)).toBeLessThan(15);
      expect(jumps).toBeLessThan(0.1);
    },
  );

  test.each(['Fox.glb', 'LeePerrySmith.glb', 'RobotExpressive.glb', 'BoomBox.glb'])(
    'on %s are as dark at 480 × 360 as at 960 × 720',
    async (file) => {
      const means: number[] = [];
      for (const scale of [0.5, 1]) {
        const shot = around(0.6, 1.9, { widthPx: 960 * scale, heightPx: 720 * scale, timeS: 0.3 });
        const text = await page.call<string>('picture', file, 'hatching', BLACK, shot);
        const pixels = Buffer.from(text, 'base64');
        mkdirSync(OUTPUT, { recursive: true });
        writeFileSync(`${OUTPUT}/${file}-${shot.widthPx}.png`, encodeImage(fromGl(shot.widthPx, shot.heightPx, pixels)));
        const inside = Array.from({ length: pixels.length / 4 }, (_, i) => i * 4).filter((at) => pixels[at + 3] === 255);
        means.push(inside.reduce((sum, at) => sum + (pixels[at] ?? 0) / 255 / inside.length, 0));
      }
      expect(Math.abs((means[0] ?? 0) - (means[1] ?? 1))).toBeLessThan(0.04);
    },
  );
});
