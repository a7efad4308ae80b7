import { expect, test } from '@jest/globals';
import { openModule, useBrowser } from '../support/browser.ts';
import type { makeAndForget } from './gl-leaks.page.ts';

const chromium = useBrowser();

test('the leak tracker counts what is alive and names who made it', async () => {
  const page = await openModule(chromium.browser, 'tests/browser/gl-leaks.page.ts');
  const { alive, report, after } = await page.call<ReturnType<typeof makeAndForget>>('makeAndForget');
  expect(alive).toEqual({ Texture: 1, Buffer: 3 });
  expect(report).toEqual([
    expect.stringMatching(/^1 × Texture made at\n {4}at .*makeAndForget/),
    expect.stringMatching(/^3 × Buffer made at\n {4}at .*forgetBuffer/),
  ]);
  expect(after).toEqual({ Buffer: 3 });
  expect(page.errors).toEqual([]);
  await page.close();
});
