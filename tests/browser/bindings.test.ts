import { describe, expect, test } from '@jest/globals';
import { formatDiagnostic } from '../../nodes/kit/diagnostics.ts';
import type { Easing } from '../../nodes/kit/ease.ts';
import { lookTwice } from '../compile/graphs.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';
import type { Played } from './bindings.page.ts';

/** From the document to the pixel: params bound to expressions and tracks, and subgraphs within subgraphs. */

const page = useModule('tests/browser/bindings.page.ts');

const CAMERA = [100, 150, 200, 255];

/** W3C Filter Effects, `sepia()`, of the camera's color, laid over itself by that much. */
function sepia(amount: number, color: readonly number[] = CAMERA): number[] {
  const [r = 0, g = 0, b = 0] = color;
  const full = [0.393 * r + 0.769 * g + 0.189 * b, 0.349 * r + 0.686 * g + 0.168 * b, 0.272 * r + 0.534 * g + 0.131 * b];
  return [...full.map((value, i) => Math.min(255, Math.round((color[i] ?? 0) * (1 - amount) + value * amount))), 255];
}

/** The picture at a time, in the middle. */
async function shown(studio: TestStudio, timeS = 0): Promise<readonly number[]> {
  const { output, diagnostics } = studio.compile();
  if (output === null) throw new Error(diagnostics.map(formatDiagnostic).join('\n'));
  expect(diagnostics).toEqual([]);
  const played = await page.call<Played>('play', output, timeS, CAMERA);
  expect({ diagnostics: played.diagnostics, error: played.error }).toEqual({ diagnostics: [], error: 0 });
  return played.center;
}

const empty = () => new TestStudio({ library: LIBRARY, readShader });

const sepiaStudio = () =>
  empty()
    .add('video-a', 'source/camera-video')
    .add('sepia-a', 'filter/sepia')
    .add('screen-a', 'output/screen')
    .wire('video-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer');

describe('a param bound to', () => {
  test('an expression follows the time, within its limits', async () => {
    const studio = sepiaStudio().bind('sepia-a.amount', { expression: 'time / 4' });
    expect(await shown(studio, 1)).toEqual(sepia(0.25));
    expect(await shown(studio, 3)).toEqual(sepia(0.75));
    expect(await shown(studio, 99)).toEqual(sepia(1));
  });

  test('a track moves along its keys, over and over', async () => {
    const keys = [
      { timeS: 0, value: 0, easing: 'linear' as const },
      { timeS: 2, value: 1, easing: 'step' as const },
      { timeS: 3, value: 0.5, easing: 'linear' as const },
    ];
    const studio = sepiaStudio().bind('sepia-a.amount', { track: { keys, repeat: 'loop' } });
    expect(await shown(studio, 0.5)).toEqual(sepia(0.25));
    expect(await shown(studio, 2.5)).toEqual(sepia(1));
    expect(await shown(studio, 7)).toEqual(sepia(0.5));
  });

  test('an expression of four numbers has a color that moves; what is no number there is as the param has it', async () => {
    const studio = empty()
      .add('video-a', 'source/camera-video')
      .add('edges-a', 'filter/sobel-edges')
      .add('screen-a', 'output/screen')
      .wire('video-a.layer -> edges-a.inputImage', 'edges-a.layer -> screen-a.layer')
      .bind('edges-a.paperColor', { expression: '[time, 1 - time, 0 / 0, 1]' });
    // A picture of one color has no edges: the drawing is all paper.
    expect(await shown(studio, 0.2)).toEqual([51, 204, 0, 255]);
  });
});

test('a value node with an expression of its own, a param bound to another, and a wire between', async () => {
  const studio = sepiaStudio()
    .add('formula-a', 'value/expression', { expression: 'a > 1 ? clamp(a - b, 0, 1) : 0', b: 1.5 })
    .bind('formula-a.a', { expression: 'time' })
    .wire('formula-a.result -> sepia-a.amount');
  expect(await shown(studio, 0.5)).toEqual(sepia(0));
  expect(await shown(studio, 2)).toEqual(sepia(0.5));
});

test('a subgraph within a subgraph, used twice, its ports and params exposed', async () => {
  const looks = empty()
    .in('look')
    .add('sepia-a', 'filter/sepia')
    .add('half-a', 'value/expression', { expression: 'a / 2' })
    .wire('half-a.result -> sepia-a.amount')
    .expose('inputs', 'picture', 'sepia-a.inputImage')
    .expose('inputs', 'strength', 'half-a.a')
    .expose('outputs', 'layer', 'sepia-a.layer');
  const studio = lookTwice(looks, 1)
    .in('main')
    .add('video-a', 'source/camera-video')
    .add('twice-a', 'graph/twice')
    .add('screen-a', 'output/screen')
    .wire('video-a.layer -> twice-a.picture', 'twice-a.layer -> screen-a.layer')
    .bind('twice-a.strength', { expression: 'time' });
  const once = sepia(0.5);
  expect(await shown(studio, 0)).toEqual(once);
  expect(await shown(studio, 0.5)).toEqual(sepia(0.25, once));
  expect(await shown(studio, 2)).toEqual(sepia(1, once));
  studio.mute('twice-a');
  expect(await shown(studio, 2)).toEqual(CAMERA);
});

/** By name, and by handles: plain ones, beyond both ends, at the corners of what may be, and upright in the middle. */
const EASINGS: readonly Easing[] = [
  ...(['linear', 'ease-in', 'ease-out', 'ease-in-out'] as const),
  [0.25, 0.1, 0.25, 1],
  [0.34, 1.56, 0.64, 1],
  [0.36, 0, 0.66, -0.56],
  [0, 1.6, 1, -0.6],
  [1, -0.6, 0, 1.6],
  [0, 0, 0, 0],
  [1, 1, 1, 1],
  [0.9, 0.05, 0.1, 0.95],
];

test('easings are those of the browser’s own animations', async () => {
  const times = Array.from({ length: 101 }, (_, i) => i / 100);
  const pairs = await page.call<{ css: number; track: number }[]>('easings', EASINGS, times);
  expect(pairs).toHaveLength(101 * EASINGS.length);
  // Chromium works its curves out to about 1e-6.
  for (const { css, track } of pairs) expect(Math.abs(css - track)).toBeLessThan(1e-5);
});
