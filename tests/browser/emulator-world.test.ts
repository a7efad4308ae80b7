import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/emulator-world.page.ts');
});
afterAll(async () => {
  await page?.close();
});

function ask<T>(name: string, ...args: readonly unknown[]): Promise<T> {
  return page.call<T>(name, ...args);
}

test('spaces are level and stay where they are until re-centered', async () => {
  const { before, after, recentered } = await ask<Record<string, Record<string, number[]>>>('spaces');
  // The head looks along −x and down; `local` begins there, upright.
  expect(before).toMatchObject({ floor: [1, 1.5, 2], local: [0, 0, 0], localUp: [0, 1, 0], localForward: [-1, 0, 0], viewer: [0, 0, 0] });
  // In a space moved by (1, 0, 2) and turned by 90° about y.
  expect(before?.shifted).toEqual([0, 1.5, 0]);
  // From (1, 1.5, 2) to (2, 1.6, 0): 2 m to the right and 1 m back of someone facing −x.
  expect(after).toMatchObject({ floor: [2, 1.6, 0], local: [2, 0.1, 1], viewer: [0, 0, 0] });
  expect(recentered).toMatchObject({ floor: [0, 1.6, 0], local: [0, 0, 0], localUp: [0, 1, 0], localForward: [0, 0, -1] });
});

test('hit tests find planes by default and solids when asked, in this frame', async () => {
  const found = await ask<Record<string, number[][]> & { cancelledTwice: string }>('hits');
  // From (0, 1.6, 0) towards (0, 0.8, −1.8): the table's top, then the floor behind it at twice the way.
  expect(found.planes).toEqual([
    [0, 0.8, -1.8],
    [0, 0, -3.6],
  ]);
  expect(found.normals).toEqual([
    [0, 1, 0],
    [0, 1, 0],
  ]);
  expect(found.solids?.[0]).toEqual([0, 0.8, -1.8]);
  expect(found.straightDown).toEqual([[0, 0, 1]]);
  // Column-major: −z turned to −y, then moved.
  expect((found.ray as unknown as number[]).map((x) => Math.round(x) + 0)).toEqual([1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 3, 1, 1]);
  expect(found.anchored).toEqual([0, 0.8, -1.8]);
  expect(found.cancelledTwice).toBe('InvalidStateError');
});

test('a touch comes, selects and goes, and its ray goes through its point', async () => {
  const { heard, hit, duringEvent } = await ask<{ heard: string[]; hit: { at: number[]; halfWidth: number }; duringEvent: unknown[] }>(
    'touches',
  );
  // The frame of an event has poses, and no views.
  expect(duringEvent).toEqual(['InvalidStateError', true]);
  expect(heard).toEqual(['+1 -0', 'selectstart screen', 'select screen', 'selectend screen', '+0 -1']);
  // Looking straight down from 2 m with the view's right towards −x: half of the half width to the right.
  expect(hit.at[0]).toBeCloseTo(-hit.halfWidth, 2);
  expect(hit.at[1]).toBeCloseTo(0, 3);
  expect(hit.at[2]).toBeCloseTo(0, 2);
});

test('a controller’s select comes with its release', async () => {
  const { held, heard, sources } = await ask<{ held: string[]; heard: string[]; sources: number }>('controllers');
  expect(held).toEqual(['selectstart right']);
  expect(heard).toEqual(['selectstart right', 'select right', 'selectend right']);
  expect(sources).toBe(2);
});

test('a DOM overlay is laid over the picture, may keep a touch, and is put back', async () => {
  const { during, heard, after } = await ask<Record<'during' | 'heard' | 'after', unknown>>('overlay');
  expect(during).toEqual({ background: 'transparent', position: 'fixed', state: 'screen' });
  expect(heard).toEqual(['selectstart']);
  expect(after).toEqual({ background: 'red', position: '' });
});

test('planes and meshes are where the room has them, and do not change from frame to frame', async () => {
  const { same, planes, meshes } = await ask<{
    same: boolean;
    planes: { label: string; orientation: string; heights: number[] }[];
    meshes: [number, number, number][];
  }>('surfaces');
  expect(same).toBe(true);
  const floor = planes.find(({ label }) => label === 'floor');
  expect(floor).toEqual({ label: 'floor', orientation: 'horizontal', heights: [0, 0, 0, 0] });
  expect(planes.find(({ label }) => label === 'table')?.heights).toEqual([0.4225, 0.4225, 0.4225, 0.4225]);
  const walls = planes.filter(({ label }) => label === 'wall');
  expect(walls).toHaveLength(4);
  for (const { orientation, heights } of walls) {
    expect(orientation).toBe('vertical');
    expect([...heights].sort()).toEqual([0, 0, 2.6, 2.6]);
  }
  expect(meshes).toHaveLength(1);
  const [[vertices, triangles, lastIndex] = [0, 0, 0]] = meshes;
  expect(triangles).toBeGreaterThan(10_000);
  expect(lastIndex).toBeLessThan(vertices);
});

test('a device that does not know the room has planes once the page has asked for a scan, which it may do once', async () => {
  const { before, after, twice } = await ask<{ before: number; after: number; twice: string }>('roomCapture');
  expect([before, twice]).toEqual([0, 'InvalidStateError']);
  expect(after).toBeGreaterThan(5);
});

test('nothing was complained about', () => {
  expect(page.errors).toEqual([]);
});
