import { expect, test } from '@jest/globals';
import type { CDPSession } from 'playwright-core';
import { openModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();

const FRAMES = 2500;
/** A number that V8 keeps on the heap: the smallest thing a function can leave behind every frame. */
const SMALLEST_OBJECT_BYTES = 12;

interface ProfileNode {
  readonly callFrame: { readonly functionName: string; readonly url: string; readonly lineNumber: number };
  readonly selfSize: number;
  readonly children: readonly ProfileNode[];
}

/** Functions of the page's module that left something behind in every frame, objects collected again included. */
async function allocators(devtools: CDPSession, run: () => Promise<unknown>): Promise<string[]> {
  await devtools.send('HeapProfiler.startSampling', {
    samplingInterval: 64,
    includeObjectsCollectedByMajorGC: true,
    includeObjectsCollectedByMinorGC: true,
  });
  await run();
  const { profile } = await devtools.send('HeapProfiler.stopSampling');
  const bytes = new Map<string, number>();
  const add = (node: ProfileNode): void => {
    const { functionName, url, lineNumber } = node.callFrame;
    const name = `${functionName}, line ${lineNumber + 1}`;
    if (url.endsWith('/module.js')) bytes.set(name, (bytes.get(name) ?? 0) + node.selfSize);
    node.children.forEach(add);
  };
  add(profile.head as ProfileNode);
  return [...bytes].filter(([, size]) => size >= FRAMES * SMALLEST_OBJECT_BYTES * 0.9).map(([name, size]) => `${name}: ${size} bytes`);
}

test('a frame of two views allocates nothing', async () => {
  const page = await openModule(chromium.browser, 'tests/browser/runtime-memory.page.ts');
  const devtools = await page.page.context().newCDPSession(page.page);
  expect(await page.call('setUp')).toBe(0);
  // Until the optimizing compiler is done: before it, every fraction between two steps of a sum is an object.
  await page.call('run', 2500);
  await page.call('runCareless', 500);
  await devtools.send('HeapProfiler.enable');
  // What allocates is seen; beside it, whatever the optimizing compiler has not come to yet.
  expect(await allocators(devtools, () => page.call('runCareless', FRAMES))).toContainEqual(expect.stringMatching(/careless/i));
  let found: string[] = [];
  for (let attempt = 0; attempt < 4; attempt++) {
    found = await allocators(devtools, () => page.call('run', FRAMES));
    if (found.length === 0) break;
    // The optimizing compiler works beside the page, and comes late on a busy machine.
    await page.call('run', 3000);
  }
  expect(found).toEqual([]);
  await page.close();
});
