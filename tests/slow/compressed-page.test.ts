import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { decodeImage, type RgbaImage } from '../support/image.ts';
import type { ProjectText } from '../support/project-kit.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';
import { texturedModel } from '../support/textured-model.ts';

const chromium = useBrowser();

const BALL: ProjectText = {
  title: 'A ball',
  nodes: {
    'ball-a1': ['source/model', { model: 'ball', clip: 'none' }],
    'sun-b2': 'light/directional',
    'scene-c3': 'layer/scene',
    'screen-d4': 'output/screen',
  },
  wires: ['ball-a1.objects -> scene-c3.objects', 'sun-b2.lights -> scene-c3.lights', 'scene-c3.layer -> screen-d4.layer'],
  assets: { ball: { path: 'assets/ball.glb', kind: 'model' } },
};

let plain: ServedExport;
let packed: ServedExport;
let single: ServedExport;
beforeAll(async () => {
  const files = { 'assets/ball.glb': await texturedModel(1024) };
  plain = await serveProjectText(BALL, files, { compress: false });
  packed = await serveProjectText(BALL, files);
  single = await serveProjectText(BALL, files, { singleFile: true });
});
afterAll(async () => {
  for (const page of [plain, packed, single]) await page.close();
});

async function visit(url: string): Promise<{ picture: RgbaImage; loaded: string[] }> {
  const context = await chromium.browser.newContext({ viewport: { width: 640, height: 480 } });
  const page = await context.newPage();
  const errors = collectErrors(page);
  const loaded: string[] = [];
  page.on('request', (request) => loaded.push(new URL(request.url()).pathname));
  await page.goto(url);
  await page.getByText('look around').waitFor();
  const picture = decodeImage(await page.screenshot());
  expect(errors).toEqual([]);
  await context.close();
  return { picture, loaded };
}

/** Mean difference of a channel, of 255. */
function difference(a: RgbaImage, b: RgbaImage): number {
  let sum = 0;
  a.data.forEach((value, i) => {
    sum += Math.abs(value - (b.data[i] ?? 0));
  });
  return sum / a.data.length;
}

test('a page with packed geometry and textures looks like one without, under its own strict policy', async () => {
  const [before, after] = [await visit(plain.url), await visit(packed.url)];
  expect(before.loaded.filter((path) => path.includes('/decoders/'))).toEqual([]);
  expect(after.loaded.filter((path) => /decoders\/basis_transcoder-[0-9a-f]{10}\.(js|wasm)$/.test(path)).length).toBeGreaterThanOrEqual(2);
  expect(difference(before.picture, after.picture)).toBeLessThan(1);
});

test('the same in one file, from a disk', async () => {
  const [before, after] = [await visit(plain.url), await visit(pathToFileURL(join(single.folder, 'index.html')).href)];
  expect(difference(before.picture, after.picture)).toBeLessThan(1);
});
