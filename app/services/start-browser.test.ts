import { chmod, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { type Chromium, findChromium } from './chromium.ts';
import { startBrowser } from './start-browser.ts';

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-start-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

/** The browser behind a script that ends `ends` times at its start, and counts the starts. */
async function ending(ends: number): Promise<{ found: Chromium; starts(): Promise<number> }> {
  const real = await findChromium({ pinnedOnly: true });
  if (!real) throw new Error('The pinned Chromium (@sparticuz/chromium) is missing: run `npm ci` on Linux x64.');
  const program = join(base, `ends-${ends}`);
  const count = `${program}.count`;
  const script = `#!/bin/sh\necho start >> '${count}'\n[ "$(wc -l < '${count}')" -le ${ends} ] && exit 3\nexec '${real.executablePath}' "$@"\n`;
  await writeFile(program, script);
  await chmod(program, 0o755);
  return {
    found: { ...real, executablePath: program },
    starts: async () => (await readFile(count, 'utf8')).trim().split('\n').length,
  };
}

test('a browser that ends while it starts is started once more', async () => {
  const { found, starts } = await ending(1);
  const browser = await startBrowser(found);
  const page = await browser.newPage();
  expect(await page.evaluate(() => 6 * 7)).toBe(42);
  await browser.close();
  expect(await starts()).toBe(2);
});

test('one that never starts is told, with how it ended', async () => {
  const { found, starts } = await ending(9);
  await expect(startBrowser(found)).rejects.toMatchObject({
    diagnostic: { code: 'SCR071', message: expect.stringContaining('exitCode=3') },
  });
  expect(await starts()).toBe(2);
});
