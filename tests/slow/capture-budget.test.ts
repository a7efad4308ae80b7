import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { PHONE_GPU_BYTES } from '../../nodes/kit/phone-memory.ts';
import type { Budget, Together } from '../browser/capture-budget.page.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();
let page: PageModule;
beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/capture-budget.page.ts');
});
afterAll(() => page.close());

async function emulate(onPhone: boolean): Promise<void> {
  const session = await page.page.context().newCDPSession(page.page);
  await session.send('Emulation.setTouchEmulationEnabled', { enabled: onPhone });
}

async function load(onPhone: boolean, vertexCount: number, depthTriangles: number, isWindowed: boolean): Promise<Budget> {
  await emulate(onPhone);
  const budget = await page.call<Budget>('load', vertexCount, depthTriangles, isWindowed);
  expect(budget).toMatchObject({ isCoarsePointer: onPhone, error: 0 });
  expect(page.errors).toEqual([]);
  return budget;
}

/** Bytes that differ by less than 2 % from what the export says. */
function expectEstimate({ bytes }: Budget, { gpuBytes }: { readonly gpuBytes: number }): void {
  expect(Math.abs(bytes / gpuBytes - 1)).toBeLessThan(0.02);
}

test('a capture whose photographs, depth maps and mesh exceed 128 MB takes at most that on phones, by smaller photographs', async () => {
  const others = await load(false, 60_000, 20_000, false);
  expect(others.bytes).toBeGreaterThan(1.3 * PHONE_GPU_BYTES);
  expectEstimate(others, others.estimated.others);
  const phone = await load(true, 60_000, 20_000, false);
  expect(phone.bytes).toBeLessThanOrEqual(PHONE_GPU_BYTES);
  expect(phone.bytes).toBeGreaterThan(0.9 * PHONE_GPU_BYTES);
  expect(phone.photoPx).toEqual(phone.estimated.phones.photoPx);
  expect(phone.photoPx[0]).toBeLessThan(others.photoPx[0]);
  expect([phone.hasDepthMeshes, phone.triangles]).toEqual([true, others.triangles]);
});

test('weights of both eyes are in it, too', async () => {
  const phone = await load(true, 200_000, 2, true);
  expect(phone.bytes).toBeLessThanOrEqual(PHONE_GPU_BYTES);
  expectEstimate(phone, phone.estimated.phones);
});

test('large depth meshes are left out on phones, and a mesh that takes more than half of it stays coarse', async () => {
  const lumigraph = await load(true, 60_000, 140_000, false);
  expect([lumigraph.hasDepthMeshes, lumigraph.bytes <= PHONE_GPU_BYTES]).toEqual([false, true]);
  const coarse = await load(true, 900_000, 2, true);
  expect(coarse.triangles).toBeLessThan(5000);
  expect(coarse.bytes).toBeLessThanOrEqual(PHONE_GPU_BYTES);
});

test('two captures and splats of a page share 128 MB on phones, and are whole elsewhere', async () => {
  await emulate(true);
  const phone = await page.call<Together>('loadTogether');
  expect(phone).toMatchObject({ isCoarsePointer: true, error: 0, splats: { count: 700_000, degree: 1 } });
  expect(phone.bytes).toBeLessThanOrEqual(PHONE_GPU_BYTES);
  expect(phone.bytes).toBeGreaterThan(0.85 * PHONE_GPU_BYTES);
  await emulate(false);
  const others = await page.call<Together>('loadTogether');
  expect(others).toMatchObject({ isCoarsePointer: false, error: 0, splats: { count: 700_000, degree: 3 } });
  expect(others.photosPx).toEqual([
    [1600, 1200],
    [1600, 1200],
  ]);
  expect(others.bytes).toBeGreaterThan(1.6 * PHONE_GPU_BYTES);
  for (const [widthPx] of phone.photosPx) expect(widthPx).toBeLessThan(1600);
  expect(page.errors).toEqual([]);
});
