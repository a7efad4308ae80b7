import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { describeProgram } from '../../export/compiler/describe.ts';
import type { Program } from '../../export/program/program.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';
import type { Act, PlayedFrames, Running } from './cpu-filters.page.ts';

/** What a filter computes is proved beside it (`nodes/filter/cpu-*`); here, how pictures come to a worker and back. */
const chromium = useBrowser();
let page: PageModule;
beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/cpu-filters.page.ts');
});
afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

type Color = readonly number[];
const RED = [255, 0, 0, 255];
const BLUE = [0, 0, 255, 255];
const GREEN = [0, 255, 0, 255];
/** As the worker makes them, which changes red and blue. */
const FROM_RED = BLUE;
const FROM_BLUE = RED;

function studio(): TestStudio {
  return new TestStudio({ library: LIBRARY, readShader })
    .add('video-a', 'source/camera-video')
    .add('cpu-a', 'filter/cpu-equalize-histogram')
    .add('screen-a', 'output/screen')
    .wire('video-a.layer -> cpu-a.inputImage')
    .wire('cpu-a.layer -> screen-a.layer');
}

function compiled(made: TestStudio): Program {
  const { output, diagnostics } = compile({ project: made.project, library: LIBRARY });
  if (!output) throw new Error(JSON.stringify(diagnostics));
  return output;
}

function play(which: string, cameras: readonly (readonly Color[])[], acts: Readonly<Record<number, Act>> = {}): Promise<PlayedFrames> {
  return page.call('playHeld', compiled(studio()), which, cameras, acts);
}

function one({ shown }: PlayedFrames): Color[] {
  return shown.map((views) => views[0] ?? []);
}

describe('frame by frame, as in a render', () => {
  test('the screen shows the previous frame, filtered; the first frame unchanged', async () => {
    const played = await play('swap', [[RED], [BLUE], [GREEN], [RED]]);
    expect(one(played)).toEqual([RED, FROM_RED, FROM_BLUE, GREEN]);
    expect(played).toMatchObject({ diagnostics: [], error: 0 });
  });

  test('each view has a picture of its own', async () => {
    const { shown } = await play('swap', [
      [RED, BLUE],
      [GREEN, RED],
      [GREEN, GREEN],
    ]);
    expect(shown).toEqual([
      [RED, BLUE],
      [FROM_RED, FROM_BLUE],
      [GREEN, FROM_RED],
    ]);
  });

  test('params are those of the frame that was sent; a recompile keeps what is under way, a reset forgets it', async () => {
    const changed = await play('swap', [[BLUE], [BLUE], [BLUE]], { 1: 'half' });
    expect(one(changed)).toEqual([BLUE, FROM_BLUE, [128, 0, 0, 255]]);
    const kept = await play('swap', [[RED], [BLUE]], { 1: 'recompile' });
    expect(one(kept)).toEqual([RED, FROM_RED]);
    const forgotten = await play('swap', [[RED], [BLUE], [BLUE]], { 1: 'reset' });
    expect(one(forgotten)).toEqual([RED, BLUE, FROM_BLUE]);
  });

  test.each([
    ['throws', 'throwing', /too sad/],
    ['cannot be started', 'broken', /Unexpected identifier/],
  ])('where the worker %s, the picture stays as it is and the user is told why', async (_what, which, reason) => {
    const played = await play(which, [[RED], [BLUE], [GREEN]]);
    expect(one(played)).toEqual([RED, BLUE, GREEN]);
    expect(played.diagnostics).toEqual([
      expect.objectContaining({ code: 'SCR047', severity: 'warning', nodeId: 'cpu-a', message: expect.stringMatching(reason) }),
    ]);
    expect(played.error).toBe(0);
  });

  test('filters go on with what came back', async () => {
    const made = compiled(
      studio()
        .add('sepia-a', 'filter/sepia', { amount: 0 })
        .unwire('cpu-a.layer -> screen-a.layer')
        .wire('cpu-a.layer -> sepia-a.inputImage')
        .wire('sepia-a.layer -> screen-a.layer'),
    );
    const played = await page.call<PlayedFrames>('playHeld', made, 'swap', [[RED], [BLUE], [BLUE]]);
    expect(one(played)).toEqual([RED, FROM_RED, FROM_BLUE]);
  });
});

test('as a page plays, frames never wait, few are late, one buffer serves all, and nothing is left behind', async () => {
  const colors = Array.from({ length: 12 }, (_, i) => [i * 20, 100, 255 - i * 20, 255]);
  const ran = await page.call<Running>('playRunning', compiled(studio()), colors);
  expect(ran.framesLate).toHaveLength(colors.length);
  // One where the browser is quick; one may be under way when the camera changes. A busy machine takes longer.
  expect(Math.min(...ran.framesLate)).toBeLessThanOrEqual(2);
  expect(Math.min(...ran.framesLate)).toBeGreaterThanOrEqual(1);
  expect(ran).toMatchObject({ buffers: 1, leaks: [], diagnostics: [], error: 0 });
});

test('a plan says so in words', () => {
  expect(describeProgram(compiled(studio()))).toContain(
    'cpu-a: sends cpu-a.picture to a worker and draws the result of an earlier frame into cpu-a.layer',
  );
});

describe('a node that reads pixels', () => {
  /** Red is bright enough for the mask, blue is not; while there is a mask, the image is gray. */
  const measuring = (): Program =>
    compiled(
      new TestStudio({ library: LIBRARY, readShader })
        .add('video-a', 'source/camera-video')
        .add('measure-a', 'layer/measure-mask', { threshold: 0.2 })
        .add('gray-a', 'filter/grey')
        .add('screen-a', 'output/screen')
        .wire('video-a.layer -> measure-a.mask')
        .wire('measure-a.inside -> gray-a.amount')
        .wire('video-a.layer -> gray-a.inputImage')
        .wire('gray-a.layer -> screen-a.layer'),
    );
  const GRAY_OF_RED = [54, 54, 54, 255];
  const GRAY_OF_BLUE = [18, 18, 18, 255];

  test('sees the previous frame of a render, and forgets it at a reset', async () => {
    const frames = [[RED], [RED], [BLUE], [BLUE], [RED], [RED]];
    const played = await page.call<PlayedFrames>('playHeld', measuring(), 'node', frames, { 5: 'reset' });
    expect(one(played)).toEqual([RED, GRAY_OF_RED, GRAY_OF_BLUE, BLUE, RED, RED]);
    expect(played).toMatchObject({ diagnostics: [], error: 0 });
  });

  test('follows a page that plays without waiting for the GPU, and leaves nothing behind', async () => {
    const stages = [
      { camera: RED, screen: GRAY_OF_RED },
      { camera: BLUE, screen: BLUE },
    ];
    const ran = await page.call<{ framesLate: number[] }>('playUntil', measuring(), stages);
    expect(Math.min(...ran.framesLate)).toBeGreaterThanOrEqual(1);
    expect(ran).toMatchObject({ leaks: [], diagnostics: [], error: 0 });
  });

  test('is in a plan with what it reads', () => {
    expect(describeProgram(measuring())).toContain('measure-a.mask.readback: reads measure-a.mask.picture back for the next frame');
  });
});
