import { join } from 'node:path';
import { expect, jest, test } from '@jest/globals';
import { openModule, useBrowser } from '../support/browser.ts';
import { compileExample } from '../support/compile-project.ts';

// Sessions of an emulated device, drawn on the CPU.
jest.setTimeout(120_000);

const chromium = useBrowser();

const TIMES = 20;

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
