import { expect, test } from '@jest/globals';
import { encode } from 'fast-png';
import { saveGraphs, useEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';

/** A wall of 4 × 4 m in front of the eye, as a capture of one photograph. */
function wallFiles(): Readonly<Record<string, Uint8Array>> {
  const positions = new Float32Array([-2, -2, -2, 2, -2, -2, 2, 2, -2, -2, 2, -2]);
  const indices = new Uint32Array([0, 1, 2, 0, 2, 3]);
  const mesh = new Uint8Array([...new Uint8Array(positions.buffer), ...new Uint8Array(indices.buffer)]);
  const worldFromCamera = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const view = { file: 'views/000.png', widthPx: 8, heightPx: 8, fxPx: 4, fyPx: 4, cxPx: 4, cyPx: 4, worldFromCamera };
  const document = { format: 'scrim-capture', version: 1, mesh: { file: 'mesh.bin', vertexCount: 4, triangleCount: 2 }, views: [view] };
  const data = Uint8Array.from({ length: 8 * 8 * 3 }, (_, i) => (i * 5) % 256);
  return {
    'wall.capture/capture.json': new TextEncoder().encode(JSON.stringify(document)),
    'wall.capture/mesh.bin': mesh,
    'wall.capture/views/000.png': encode({ width: 8, height: 8, data, channels: 3 }),
  };
}

const open = useEditor();

test('two clicks in the preview and a known distance give a capture its true size; a click on the floor puts it at height 0', async () => {
  const { page, editor, project, errors } = await open({
    nodes: {
      'wall-aaaa': { type: 'source/capture', params: { file: 'wall', method: 'plain' } },
      'screen-aaaa': { type: 'output/screen' },
    },
    wires: ['wall-aaaa.layer -> screen-aaaa.layer'],
    places: { 'wall-aaaa': [0, 0], 'screen-aaaa': [300, 0] },
    assets: { wall: { path: 'assets/wall.capture/capture.json', kind: 'capture' } },
    assetFiles: wallFiles(),
  });
  await editor.settled();
  await editor.hold();
  await editor.node('wall').locator('.node-title').click();
  const { inspector } = editor;
  const section = inspector.getByRole('region', { name: 'True size' });
  const box = await page.locator('iframe[title="Preview"]').boundingBox();
  if (!box) throw new Error('There is no preview.');
  /** Clicks where the magnifier is, which follows the pointer once moves reach the overlay over the preview. */
  const click = async (x: number, y: number) => {
    const loupe = page.locator('.loupe');
    const at = { x: box.x + box.width * x, y: box.y + box.height * y };
    await eventually(async () => {
      await page.mouse.move(at.x - 5, at.y);
      await page.mouse.move(at.x, at.y);
      const left = await loupe.evaluate(({ style }) => Number.parseFloat(style.left), undefined, { timeout: 2000 });
      expect(Math.abs(left - 100 * x)).toBeLessThan(0.5);
    });
    await page.mouse.click(at.x, at.y);
  };

  /** The distance between two places of the preview, in meters. */
  const measure = async () => {
    await section.getByRole('button', { name: 'Set scale by two points' }).click();
    await page.getByRole('application', { name: 'First point: pick a point from the preview' }).waitFor();
    await click(0.4, 0.5);
    await page.getByRole('application', { name: 'Second point' }).waitFor();
    await click(0.6, 0.5);
    const words = await section.getByText(/The points are .* m apart now\./).textContent();
    return Number(/[\d.]+/.exec(words ?? '')?.[0]);
  };
  const measuredM = await measure();
  expect(measuredM).toBeGreaterThan(0.1);
  await section.getByRole('textbox', { name: 'True distance (m)' }).fill('zero');
  await section.getByRole('button', { name: 'Set scale', exact: true }).click();
  await section.getByRole('alert').waitFor();
  await section.getByRole('textbox', { name: 'True distance (m)' }).fill(String(measuredM * 2));
  await section.getByRole('button', { name: 'Set scale', exact: true }).click();
  const scale = inspector
    .getByRole('spinbutton', { name: 'Scale' })
    .or(inspector.getByRole('textbox', { name: 'Scale' }))
    .first();
  // The distance is shown in millimeters.
  expect(Number((await scale.inputValue()).replace(/[^\d.]/g, ''))).toBeCloseTo(2, 1);
  // The wall is twice as far away. The room behind it, whose depth is known too, stays where it is.
  expect(await measure()).toBeGreaterThan(measuredM * 1.3);

  await section.getByRole('button', { name: 'Put floor at height 0' }).click();
  await page.getByRole('application', { name: 'Floor: pick a point from the preview' }).waitFor();
  await click(0.5, 0.8);
  await section.getByText('Click the floor').waitFor({ state: 'detached' });
  const { main } = await saveGraphs({ page, project });
  const { positionM } = main?.nodes['wall-aaaa']?.params ?? {};
  expect(positionM).toEqual([0, expect.any(Number), 0]);
  expect(positionM).not.toEqual([0, 0, 0]);
  if (process.env.SHOT) await page.screenshot({ path: '/tmp/true-size.png' });
  expect(errors).toEqual([]);
});
