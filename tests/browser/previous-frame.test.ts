import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';
import type { Act } from './previous-frame.page.ts';

const page = useModule('tests/browser/previous-frame.page.ts');

type Color = readonly number[];
const WHITE = [255, 255, 255, 255];
const BLACK = [0, 0, 0, 255];
const RED = [255, 0, 0, 255];
const BLUE = [0, 0, 255, 255];
const NOTHING = [0, 0, 0, 0];

/** A screen that shows the layer's own premultiplied pixels, and no world behind them. */
const TRANSPARENT = { background: 'color', color: NOTHING };

/** The camera, at a part of its opacity, over the previous frame. */
function trail(opacity: number, more: (studio: TestStudio) => TestStudio = (studio) => studio): Program {
  const studio = new TestStudio({ library: LIBRARY, readShader })
    .add('video-a', 'source/camera-video')
    .add('over-a', 'operator/over', { opacity })
    .add('previous-a', 'layer/previous-frame')
    .add('screen-a', 'output/screen', TRANSPARENT)
    .wire('video-a.layer -> over-a.top')
    .wire('previous-a.layer -> over-a.bottom')
    .wire('over-a.layer -> previous-a.layer')
    .wire('over-a.layer -> screen-a.layer');
  return compiled(more(studio));
}

function compiled(studio: TestStudio): Program {
  const { output, diagnostics } = compile({ project: studio.project, library: LIBRARY, options: { taps: ['previous-a.layer'] } });
  if (!output) throw new Error(JSON.stringify(diagnostics));
  return output;
}

interface Played {
  readonly shown: readonly (readonly Color[])[];
  readonly tapped: readonly Color[];
}

async function play(first: Program, cameras: readonly (readonly Color[])[], acts: readonly Act[] = [], second = first): Promise<Played> {
  const played = await page.call<Played & { diagnostics: unknown[]; error: number }>(
    'play',
    first,
    second,
    cameras,
    acts,
    'previous-a.layer',
  );
  expect({ diagnostics: played.diagnostics, error: played.error }).toEqual({ diagnostics: [], error: 0 });
  return played;
}

/** `over` by hand, rounded to 8 bits in every frame as layers are. Premultiplied: alpha counts like a color. */
function byHand(cameras: readonly Color[], opacity: number, start: Color = NOTHING): Color[] {
  let kept = start;
  return cameras.map((camera) => {
    const alpha = ((camera[3] ?? 0) / 255) * opacity;
    kept = kept.map((value, i) => Math.round((camera[i] ?? 0) * opacity + value * (1 - alpha)));
    return kept;
  });
}

function first({ shown }: Played): Color[] {
  return shown.map((views) => views[0] ?? []);
}

function expectClose(actual: readonly Color[], expected: readonly Color[]): void {
  expect(actual).toHaveLength(expected.length);
  actual.forEach((color, i) => {
    color.forEach((value, channel) => {
      const wanted = expected[i]?.[channel] ?? Number.NaN;
      if (!(Math.abs(value - wanted) <= 1)) throw new Error(`Frame ${i} shows ${color.join()} instead of ${expected[i]?.join()}.`);
    });
  });
}

describe('what is fed back', () => {
  const cameras = [WHITE, BLACK, BLACK, BLACK, BLACK, RED];

  test('decays frame by frame as worked out by hand, and shows nothing in the first', async () => {
    const played = await play(
      trail(0.5),
      cameras.map((color) => [color]),
    );
    expectClose(first(played), byHand(cameras, 0.5));
    expect(played.tapped[0]).toEqual(NOTHING);
    // The node gives what the screen showed one frame earlier.
    expect(played.tapped.slice(1)).toEqual(first(played).slice(0, -1));
  });

  test('is gone after a reset', async () => {
    const played = await play(
      trail(0.25),
      [WHITE, WHITE, BLACK, BLACK].map((color) => [color]),
      ['nothing', 'nothing', 'reset'],
    );
    expectClose(first(played).slice(2), byHand([BLACK, BLACK], 0.25));
  });

  test('survives a recompile that changes the graph around it', async () => {
    const other = trail(0.25, (studio) =>
      studio
        .add('sepia-a', 'filter/sepia', { amount: 0 })
        .unwire('over-a.layer -> screen-a.layer')
        .wire('over-a.layer -> sepia-a.inputImage')
        .wire('sepia-a.layer -> screen-a.layer'),
    );
    const seen = [WHITE, BLACK, BLACK, BLACK];
    const played = await play(
      trail(0.25),
      seen.map((color) => [color]),
      ['nothing', 'nothing', 'recompile'],
      other,
    );
    expectClose(first(played), byHand(seen, 0.25));
  });

  test('is each view’s own', async () => {
    const left = [RED, BLACK, BLACK];
    const right = [BLUE, BLACK, WHITE];
    const { shown } = await play(
      trail(0.5),
      left.map((color, i) => [color, right[i] ?? BLACK]),
    );
    expectClose(
      shown.map((views) => views[0] ?? []),
      byHand(left, 0.5),
    );
    expectClose(
      shown.map((views) => views[1] ?? []),
      byHand(right, 0.5),
    );
  });
});

describe('without a loop', () => {
  const video = () =>
    new TestStudio({ library: LIBRARY, readShader }).add('video-a', 'source/camera-video').add('screen-a', 'output/screen', TRANSPARENT);

  test('the screen is one frame late', async () => {
    const late = compiled(
      video()
        .add('previous-a', 'layer/previous-frame')
        .wire('video-a.layer -> previous-a.layer')
        .wire('previous-a.layer -> screen-a.layer'),
    );
    const played = await play(
      late,
      [RED, BLUE, WHITE, BLACK].map((color) => [color]),
    );
    expect(first(played)).toEqual([NOTHING, RED, BLUE, WHITE]);
  });

  test('two in a row are two frames late', async () => {
    const later = compiled(
      video()
        .add('previous-b', 'layer/previous-frame')
        .add('previous-a', 'layer/previous-frame')
        .wire('video-a.layer -> previous-b.layer')
        .wire('previous-b.layer -> previous-a.layer')
        .wire('previous-a.layer -> screen-a.layer'),
    );
    const played = await play(
      later,
      [RED, BLUE, WHITE, BLACK].map((color) => [color]),
    );
    expect(first(played)).toEqual([NOTHING, NOTHING, RED, BLUE]);
  });
});
