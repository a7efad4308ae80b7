import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/loop-guard.page.ts');

const BLUE = [0, 0, 255, 255];
/** The node's second pass halves what the first gives it. */
const HALF_GREEN = [0, 128, 0, 255];
const HALF_BLUE = [0, 0, 128, 255];

test('an endless loop is never drawn: its picture passes through, and its line is told until the shader changes', async () => {
  expect(await page.call('endless')).toEqual({
    // The GPU shuts the pass out by itself; that the whole node is left out is known some frames later.
    first: HALF_BLUE,
    bypassed: BLUE,
    told: [expect.objectContaining({ code: 'SCR044', severity: 'error', nodeId: 'looped', file: 'shaders/looped.fs', line: 3, column: 3 })],
    stillTold: 1,
    stillBypassed: BLUE,
    mended: HALF_GREEN,
    taken: [],
    error: 0,
  });
});

test('a heavy loop is drawn; one that a param makes too long is left out until the param lets it end', async () => {
  expect(await page.call('tooLong')).toEqual({ heavy: HALF_GREEN, atOnce: HALF_BLUE, again: HALF_GREEN, error: 0 });
});

test('long loops that the text counts are drawn all the same, with a warning', async () => {
  expect(await page.call('counted')).toEqual({
    first: HALF_GREEN,
    on: HALF_GREEN,
    told: [expect.objectContaining({ code: 'SCR044', severity: 'warning', nodeId: 'looped', file: 'shaders/looped.fs', line: 4 })],
    taken: [],
    error: 0,
  });
});

test('nothing stays behind on the GPU, and programs without loops pay nothing', async () => {
  expect(await page.call('leavesNothing')).toEqual([]);
  expect(await page.call('withoutLoops')).toEqual({ framebuffers: 0, programs: 2 });
});
