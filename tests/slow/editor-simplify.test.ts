import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { NodeIO } from '@gltf-transform/core';
import { expect, test } from '@jest/globals';
import { meshAsGlb } from '../../export/captures/write-glb.ts';
import { readCapture } from '../../nodes/kit/capture.ts';
import { axeFindings } from '../support/axe.ts';
import { withBall } from '../support/ball-project.ts';
import { describeWithBlender } from '../support/blender.ts';
import { chooseOption } from '../support/choose-option.ts';
import { type GraphText, type OpenEditor, saveGraphs, useEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { farthest, torus } from '../support/torus.ts';

const GRAPH: GraphText = {
  nodes: { 'video-aaaa': { type: 'source/camera-video' }, 'screen-aaaa': { type: 'output/screen' } },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'screen-aaaa': [300, 0] },
  assets: { 'ring-aaaa': { path: 'assets/ring.glb', kind: 'model' } },
  assetFiles: { 'ring.glb': meshAsGlb(torus(320, 120)) },
};

const open = useEditor();
const dialogOf = ({ page }: OpenEditor) => page.getByRole('dialog', { name: 'Simplify a model' });
const field = (window: OpenEditor, name: string) => dialogOf(window).getByRole('textbox', { name, exact: true });
const shot = async ({ page }: OpenEditor, name: string) => {
  if (process.env.SHOT) await page.screenshot({ path: `${process.env.SHOT}-${name}.png` });
};

async function savedPaths(window: OpenEditor): Promise<readonly string[]> {
  await saveGraphs(window);
  const { assets } = JSON.parse(await readFile(join(window.project, 'project.scrim.json'), 'utf8')) as {
    assets: Record<string, { path: string }>;
  };
  return Object.values(assets)
    .map(({ path }) => path)
    .sort();
}

async function openFromAssets(window: OpenEditor): Promise<void> {
  const { page } = window;
  await page.keyboard.press('Shift+R');
  await page.getByRole('button', { name: 'Simplify ring.glb…' }).click();
}

test('a program that is missing is named with the place to get it', async () => {
  const window = await open(GRAPH);
  await openFromAssets(window);
  const dialog = dialogOf(window);
  await field(window, 'Blender (empty: the one in PATH)').fill('/none/blender');
  await dialog.getByText('https://www.blender.org/download/').waitFor();
  await dialog.getByText('76,800 triangles.').waitFor();
  expect(await dialog.getByRole('button', { name: 'Simplify', exact: true }).isDisabled()).toBe(true);
  // Another program is not run.
  await field(window, 'Blender (empty: the one in PATH)').fill('/bin/sh');
  await dialog.getByText('/bin/sh is not Blender').waitFor();
  await shot(window, 'missing');
});

describeWithBlender('a model that is simplified in the editor', () => {
  test('is a new asset with its output shown, or nothing after a cancel; replaced, undo brings it back', async () => {
    const window = await open(GRAPH, { colorScheme: 'dark' });
    const { page, editor, project } = window;
    await editor.settled();
    await openFromAssets(window);
    const dialog = dialogOf(window);
    await dialog.getByText('76,800 triangles. Blender').waitFor();
    expect(await field(window, 'Triangles, at most').inputValue()).toBe('38400');
    const go = dialog.getByRole('button', { name: 'Simplify', exact: true });
    await field(window, 'Triangles, at most').fill('76800');
    await dialog.getByText('It has no more triangles than that.').waitFor();
    expect(await go.isDisabled()).toBe(true);
    await field(window, 'Triangles, at most').fill('1500');
    await shot(window, 'start');
    for (const colorScheme of ['dark', 'light'] as const) {
      await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
      expect([colorScheme, await axeFindings(page)]).toEqual([colorScheme, []]);
    }

    await go.click();
    await dialog.getByRole('button', { name: 'Cancel' }).click();
    await page.getByText('Simplification canceled.').waitFor();
    expect(await page.getByRole('table', { name: 'Assets' }).getByRole('row').count()).toBe(2);

    await go.click();
    await dialog.getByRole('listitem').filter({ hasText: 'Blender' }).and(dialog.locator('[aria-current="step"]')).waitFor();
    await eventually(async () => expect(await field(window, 'Output of Blender').inputValue()).toContain('scrim: Reading the mesh'));
    await shot(window, 'running');
    await page.getByText('Added ring-simple.glb.').waitFor();
    await page.getByRole('rowheader', { name: 'ring-simple.glb' }).waitFor();
    // The preview draws it.
    await page
      .getByRole('row', { name: /ring-simple.glb/ })
      .locator('img.asset-picture')
      .waitFor();
    await shot(window, 'finished');
    const [mesh] = (await new NodeIO().read(join(project, 'assets/ring-simple.glb'))).getRoot().listMeshes();
    const [primitive] = mesh?.listPrimitives() ?? [];
    const count = (primitive?.getIndices()?.getCount() ?? 0) / 3;
    expect([count > 1400, count <= 1500]).toEqual([true, true]);
    const positions = Float32Array.from(primitive?.getAttribute('POSITION')?.getArray() ?? []);
    expect(farthest({ positions, indices: new Uint32Array() })).toBeLessThan(0.02);

    await page.getByRole('button', { name: 'Simplify ring.glb…' }).click();
    await dialog.getByText('76,800 triangles. Blender').waitFor();
    await field(window, 'Triangles, at most').fill('700');
    await chooseOption(dialog.getByRole('combobox', { name: 'Result' }), 'replace');
    await go.click();
    await page.getByText('Simplified ring.glb.').waitFor();
    expect(await savedPaths(window)).toEqual(['assets/ring-simple-2.glb', 'assets/ring-simple.glb']);
    await page.keyboard.press('Control+z');
    expect(await savedPaths(window)).toEqual(['assets/ring-simple.glb', 'assets/ring.glb']);
  });

  test('a capture that is replaced shows its photographs on the simpler mesh', async () => {
    const window = await open(await withBall());
    const { page, editor, project } = window;
    await editor.settled();
    const before = await editor.rewind();
    await page.keyboard.press('Shift+R');
    await page.getByRole('button', { name: 'Simplify ball.capture…' }).click();
    await dialogOf(window).getByText('triangles. Blender').waitFor();
    await field(window, 'Triangles, at most').fill('300');
    await chooseOption(dialogOf(window).getByRole('combobox', { name: 'Result' }), 'replace');
    await dialogOf(window).getByRole('button', { name: 'Simplify', exact: true }).click();
    await page.getByText('Simplified ball.capture.').waitFor();
    expect(await savedPaths(window)).toEqual(['assets/ball-simple.capture/capture.json']);
    const [old, simple] = await Promise.all(
      ['ball', 'ball-simple'].map(async (name) =>
        readCapture(await readFile(join(project, `assets/${name}.capture/capture.json`), 'utf8')),
      ),
    );
    expect(simple?.views).toEqual(old?.views);
    expect(simple?.mesh.triangleCount).toBeLessThanOrEqual(300);
    await page.getByRole('button', { name: 'Add a node with ball-simple.capture' }).click();
    await editor.imageOtherThan(before, 500);
    await shot(window, 'capture');
  });
});
