import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { openModule, useBrowser } from '../support/browser.ts';
import { compileExample, compileText } from '../support/compile-project.ts';
import { projectText } from '../support/project-kit.ts';

const chromium = useBrowser();

const TIMES = 20;

/** Each tells what came before it was there: a start, and all that follows from it. */
const STARTS = projectText({
  nodes: {
    'start-a1b2': 'pulse/on-start',
    'counter-a1b2': 'value/counter',
    'box-a1b2': 'objects/primitive',
    'light-a1b2': 'light/directional',
    'scene-a1b2': 'layer/scene',
    'sepia-a1b2': 'filter/sepia',
    'screen-a1b2': 'output/screen',
  },
  wires: [
    'start-a1b2.pulse -> counter-a1b2.up',
    'counter-a1b2.number -> sepia-a1b2.amount',
    'box-a1b2.objects -> scene-a1b2.objects',
    'light-a1b2.lights -> scene-a1b2.lights',
    'scene-a1b2.layer -> sepia-a1b2.inputImage',
    'sepia-a1b2.layer -> screen-a1b2.layer',
  ],
});

test('the first frame finds everything compiled, and begins at the beginning', async () => {
  const page = await openModule(chromium.browser, 'tests/browser/robustness.page.ts', {
    mounts: { '/examples/': join(process.cwd(), 'examples') },
  });
  const boxes = await page.call('firstFrame', compileText(STARTS), 'examples/', ['counter-a1b2.number']);
  expect(boxes).toMatchObject({ during: 0, spied: { 'counter-a1b2.number': 1 }, said: [] });
  const models = await page.call('firstFrame', await compileExample('examples/first-light'), 'examples/first-light/', []);
  expect(models).toMatchObject({ during: 0, said: [] });
  expect(page.errors).toEqual([]);
  await page.close();
});

test('twenty times into AR and out again leave as many GPU objects as once', async () => {
  const page = await openModule(chromium.browser, 'tests/browser/robustness.page.ts', {
    mounts: { '/examples/': join(process.cwd(), 'examples') },
  });
  const program = await compileExample('examples/first-light');
  const { alive, ...rest } = await page.call<{ alive: string[] }>('enterAndLeave', program, 'examples/first-light/', TIMES);
  expect(rest).toEqual({ drawn: expect.any(Number), error: 0, said: [], after: [] });
  expect((rest as unknown as { drawn: number }).drawn).toBeGreaterThanOrEqual(TIMES * 3);
  expect(alive).toHaveLength(TIMES);
  expect(new Set(alive)).toEqual(new Set([alive[0]]));
  expect(page.errors).toEqual([]);
  await page.close();
});
