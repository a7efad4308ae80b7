import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { inspect } from '@gltf-transform/functions';
import { beforeAll, expect, test } from '@jest/globals';
import { MeshoptDecoder } from 'meshoptimizer';
import sharp from 'sharp';
import { saveGraphs, useEditor } from '../support/open-editor.ts';

const ROBOT = resolve(import.meta.dirname, '../../examples/first-light/assets/robot.glb');

const open = useEditor();
let robot = new Uint8Array();
let stripes = new Uint8Array();
let stripe = new Uint8Array();
beforeAll(async () => {
  robot = new Uint8Array(await readFile(ROBOT));
  const solid = (background: string) => sharp({ create: { width: 40, height: 30, channels: 3, background } });
  stripes = new Uint8Array(await solid('#ff0000').png().toBuffer());
  stripe = new Uint8Array(await solid('#00ff00').png().toBuffer());
});

/** A project that uses a model and one of two images. */
const graph = () =>
  ({
    nodes: {
      'model-aaaa': { type: 'source/model', params: { model: 'robot' } },
      'scene-aaaa': { type: 'layer/scene' },
      'image-aaaa': { type: 'source/image-file', params: { file: 'red' } },
      'screen-aaaa': { type: 'output/screen' },
    },
    wires: ['model-aaaa.objects -> scene-aaaa.objects', 'image-aaaa.layer -> screen-aaaa.layer'],
    places: { 'model-aaaa': [0, 0], 'scene-aaaa': [260, 0], 'image-aaaa': [0, 240], 'screen-aaaa': [520, 100] },
    assets: {
      robot: { path: 'assets/robot.glb', kind: 'model' },
      red: { path: 'assets/red.png', kind: 'image' },
      green: { path: 'assets/green.png', kind: 'image' },
    },
    assetFiles: { 'robot.glb': robot, 'red.png': stripes, 'green.png': stripe },
  }) as const;

/** The share of covered pixels of a picture and the number of its colors. */
const look = async (image: HTMLImageElement) => {
  await image.decode();
  const context = new OffscreenCanvas(image.naturalWidth, image.naturalHeight).getContext('2d');
  context?.drawImage(image, 0, 0);
  const {
    data = new Uint8ClampedArray(),
    width = 1,
    height = 1,
  } = context?.getImageData(0, 0, image.naturalWidth, image.naturalHeight) ?? {};
  const colors = new Set<number>();
  let covered = 0;
  let atEdge = 0;
  for (let i = 0; i < width * height; i++) {
    if ((data[4 * i + 3] ?? 0) < 128) continue;
    covered++;
    const [x, y] = [i % width, Math.floor(i / width)];
    if (x === 0 || y === 0 || x === width - 1 || y === height - 1) atEdge++;
    colors.add(((data[4 * i] ?? 0) >> 4) * 256 + ((data[4 * i + 1] ?? 0) >> 4) * 16 + ((data[4 * i + 2] ?? 0) >> 4));
  }
  return { covered: covered / (width * height), atEdge, colors: colors.size };
};

test('the list of assets shows models whole, and what each file takes on the GPU', async () => {
  const { page, editor } = await open(graph());
  await page.keyboard.press('Shift+R');
  const row = (name: string) => page.getByRole('row', { name: new RegExp(name) });
  const picture = row('robot.glb').locator('img.asset-picture');
  await picture.waitFor({ timeout: 60_000 });
  const { covered, atEdge, colors } = await picture.evaluate(look);
  expect(covered).toBeGreaterThan(0.1);
  expect(colors).toBeGreaterThan(8);
  expect(atEdge).toBe(0);

  const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({ 'meshopt.decoder': MeshoptDecoder });
  const { meshes, textures } = inspect(await io.readBinary(robot));
  const bytes =
    meshes.properties.reduce((sum, { size }) => sum + size, 0) + textures.properties.reduce((sum, { gpuSize }) => sum + (gpuSize ?? 0), 0);
  const shown = await row('robot.glb').locator('td').nth(2).textContent();
  const [number = '', unit = ''] = (shown ?? '').split(' ');
  const shownBytes = Number(number) * ({ B: 1, kB: 1e3, MB: 1e6 }[unit] ?? Number.NaN);
  expect(Math.abs(shownBytes - bytes) / bytes).toBeLessThan(0.1);
  // 40 × 30 pixels of four bytes.
  expect(await row('red.png').locator('td').nth(2).textContent()).toBe('5 kB');

  // The list of images shows in the preview what a choice would do.
  await editor.node('image').locator('.node-title').click();
  await editor.inspector.getByRole('combobox', { name: 'File', exact: true }).click();
  const before = await editor.restingImage();
  await page.getByRole('option', { name: 'green.png' }).hover();
  await editor.imageOtherThan(before);
  await page.keyboard.press('Escape');
  await editor.imageSameAs(before);
});

test('a color of the project is shown while the pointer rests on its swatch, and a press uses it', async () => {
  const image = graph();
  const opened = await open({
    ...image,
    nodes: {
      'image-aaaa': image.nodes['image-aaaa'],
      'dots-aaaa': { type: 'filter/halftone', params: { inkColor: [0, 0, 1, 1] } },
      'screen-aaaa': { type: 'output/screen' },
    },
    wires: ['image-aaaa.layer -> dots-aaaa.inputImage', 'dots-aaaa.layer -> screen-aaaa.layer'],
    places: { 'image-aaaa': [0, 240], 'dots-aaaa': [260, 100], 'screen-aaaa': [520, 100] },
  });
  const { page, editor } = opened;
  await editor.node('dots').locator('.node-title').click();
  const before = await editor.restingImage();
  const swatch = editor.inspector.getByRole('group', { name: 'Paper, colors of the project' }).getByRole('button', { name: 'Use #0000ff' });
  await swatch.hover();
  await editor.imageOtherThan(before);
  await page.mouse.move(5, 5);
  await editor.imageSameAs(before);
  await swatch.click();
  const { main } = await saveGraphs(opened);
  expect(main?.nodes['dots-aaaa']?.params).toMatchObject({ paperColor: [0, 0, 1, 1] });

  // The swatch goes with the selection while the pointer rests on it.
  await page.keyboard.press('Control+z');
  await swatch.hover();
  await editor.imageOtherThan(before);
  await page.locator('.canvas').focus();
  await page.keyboard.press('Control+a');
  await swatch.waitFor({ state: 'detached' });
  await editor.imageSameAs(before);
});
