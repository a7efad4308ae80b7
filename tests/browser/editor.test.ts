import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { centerOf } from '../../tools/lib/center-of.ts';
import { frameOf } from '../../tools/lib/frame-of.ts';
import { chooseOption } from '../support/choose-option.ts';
import { encodeImage } from '../support/image.ts';
import { type GraphText, saveGraphs, useEditor } from '../support/open-editor.ts';

/** The camera's image goes to the screen; a number stands by. */
const SIMPLE: GraphText = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video' },
    'number-aaaa': { type: 'value/number', params: { value: 3 } },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
  places: { 'video-aaaa': [0, 0], 'number-aaaa': [0, 200], 'screen-aaaa': [520, 0] },
};

/** Longer than a click takes on a slow machine. */
const BUSY_MS = 8000;

const openEditor = useEditor();
const start = (graph: GraphText = SIMPLE) => openEditor(graph);

test('a preview that is busy does not hold up the editor', async () => {
  const { page, editor } = await start();
  const preview = await frameOf(page);
  let isBusy = true;
  const busy = preview
    .evaluate((ms) => {
      for (const untilMs = performance.now() + ms; performance.now() < untilMs; );
    }, BUSY_MS)
    .then(() => {
      isBusy = false;
    });
  await editor.node('number').locator('.node-title').click();
  await editor.inspector.getByRole('heading', { name: 'Number' }).waitFor();
  expect(isBusy).toBe(true);
  await busy;
});

describe('wires', () => {
  test('a wire that cannot be is dimmed, says why beside the pointer, and again when let go', async () => {
    const { page, editor } = await start();
    const from = await centerOf(editor.port('number-aaaa', 'number', 'source'));
    const target = editor.port('screen-aaaa', 'layer', 'target');
    const to = await centerOf(target);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x - 60, to.y, { steps: 5 });
    await page.locator('[data-node="screen-aaaa"].node-dimmed').waitFor();
    await page.mouse.move(to.x, to.y, { steps: 5 });
    const hint = page.locator('.connection-hint');
    expect(await hint.textContent()).toMatch(/outputs “Number”, but .* takes “Layer”/);
    await page.mouse.up();
    await hint.waitFor({ state: 'detached' });
    await page
      .getByRole('log', { name: 'Messages' })
      .getByText(/outputs “Number”/)
      .waitFor();
    expect(await page.locator('.react-flow__edge').count()).toBe(1);
  });

  test('let go over the canvas, it asks for a node that fits and wires it, all in one step', async () => {
    const { page, editor } = await start();
    await editor.drag(await centerOf(editor.port('video-aaaa', 'layer', 'source')), await editor.emptyPlace());
    const list = page.getByRole('listbox', { name: 'Node types' });
    await list.waitFor();
    const offered = await list.getByRole('option').allTextContents();
    expect(offered.some((text) => text.startsWith('Sepia'))).toBe(true);
    expect(offered.some((text) => text.startsWith('Math') || text.startsWith('Model'))).toBe(false);
    await page.keyboard.type('gauss');
    await page.keyboard.press('Enter');
    await editor.node('gaussian-blur').waitFor();
    expect(await page.locator('.react-flow__edge').count()).toBe(2);
    await page.keyboard.press('Control+z');
    await editor.node('gaussian-blur').waitFor({ state: 'detached' });
    expect(await page.locator('.react-flow__edge').count()).toBe(1);
  });

  test('pulled off its port and let go, it is gone; undo brings it back', async () => {
    const { page, editor } = await start();
    const end = await centerOf(editor.port('screen-aaaa', 'layer', 'target'));
    await editor.drag({ x: end.x - 24, y: end.y }, await editor.emptyPlace());
    await page.locator('.react-flow__edge').waitFor({ state: 'detached' });
    await page.keyboard.press('Control+z');
    await page.locator('.react-flow__edge').waitFor({ state: 'attached' });
  });

  test('without a pointer, the inspector wires', async () => {
    const { page, editor } = await start();
    await editor.addNode('gaussian');
    await page.getByRole('combobox', { name: 'Connect to Layer' }).click();
    await page.getByRole('option', { name: 'Camera video · Layer' }).click();
    await editor.inspector.getByRole('button', { name: /Camera video · Layer/ }).waitFor();
    expect(await page.locator('.react-flow__edge').count()).toBe(2);
  });
});

describe('nodes', () => {
  test('by keys alone: Tab, a search, Enter, and the arrow keys move what was added, as one step', async () => {
    const { page, editor } = await start();
    const { x, y } = await editor.emptyPlace();
    await page.mouse.click(x, y);
    await page.keyboard.press('Tab');
    await page.keyboard.type('edges');
    await page.getByRole('option', { name: /Sobel/ }).waitFor();
    await page.keyboard.press('Enter');
    const node = editor.node('sobel');
    await page.locator('.react-flow__node:focus').waitFor();
    const before = await centerOf(node);
    for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowRight');
    expect((await centerOf(node)).x).toBeGreaterThan(before.x + 20);
    await page.keyboard.press('Control+z');
    expect((await centerOf(node)).x).toBeCloseTo(before.x, 0);
    await page.keyboard.press('Delete');
    await node.waitFor({ state: 'detached' });
  });

  test('dragged over the canvas, they are selected, copied, deleted and brought back together', async () => {
    const { page, editor } = await start();
    const a = await editor.node('video-aaaa').boundingBox();
    const b = await editor.node('number-aaaa').boundingBox();
    if (!a || !b) throw new Error('The nodes are not on screen.');
    await editor.drag({ x: a.x - 30, y: a.y - 30 }, { x: b.x + b.width + 20, y: b.y + b.height + 20 });
    await page.getByRole('heading', { name: '2 nodes' }).waitFor();
    await page.keyboard.press('Control+d');
    expect(await page.locator('.react-flow__node').count()).toBe(5);
    await page.keyboard.press('Delete');
    expect(await page.locator('.react-flow__node').count()).toBe(3);
    await page.keyboard.press('Control+z');
    expect(await page.locator('.react-flow__node').count()).toBe(5);
  });

  test('dragged, they move in one step that undo takes back', async () => {
    const { page, editor } = await start();
    const before = await centerOf(editor.node('number-aaaa').locator('.node-title'));
    await editor.drag(before, { x: before.x + 160, y: before.y + 64 });
    const after = await centerOf(editor.node('number-aaaa').locator('.node-title'));
    expect(after.x - before.x).toBeGreaterThan(100);
    await page.keyboard.press('Control+z');
    expect((await centerOf(editor.node('number-aaaa').locator('.node-title'))).x).toBeCloseTo(before.x, 0);
  });

  test('a Shadertoy source is pasted into its dialogue, and becomes a shader with its credit', async () => {
    const { page, editor } = await start();
    const place = await editor.emptyPlace();
    await page.mouse.click(place.x, place.y, { button: 'right' });
    await page.getByRole('menuitem', { name: 'Import Shadertoy…' }).click();
    const dialog = page.getByRole('dialog', { name: 'Import Shadertoy' });
    const source = dialog.getByLabel('Code or JSON');
    await source.fill('// Buffer A\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }');
    await dialog.getByText('The Image tab is missing.').waitFor();
    expect(await dialog.getByRole('button', { name: 'Import' }).isDisabled()).toBe(true);
    await source.fill('// Created by Ada Example\nvoid mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p / iResolution.xy); }');
    await dialog.getByText(/Created by Ada Example.*CC BY-NC-SA 3\.0/).waitFor();
    await dialog.getByLabel('Name').fill('Rings');
    await dialog.getByRole('button', { name: 'Import' }).click();
    const node = page.locator('.react-flow__node', { hasText: 'Rings' });
    await node.waitFor();
    await page.getByRole('region', { name: 'About' }).getByText('Created by Ada Example').waitFor();
    await page.keyboard.press('Control+z');
    await node.waitFor({ state: 'detached' });
  });

  test('a dropped picture becomes an asset of the project and a node that shows it', async () => {
    const { page, editor, project } = await start();
    const png = Buffer.from(encodeImage({ width: 2, height: 2, data: new Uint8Array(16).fill(200) })).toString('base64');
    const place = await editor.emptyPlace();
    await page.evaluate(
      ({ bytes, x, y }) => {
        const data = new DataTransfer();
        data.items.add(new File([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], 'gray.png', { type: 'image/png' }));
        const target = document.elementFromPoint(x, y);
        for (const kind of ['dragover', 'drop']) {
          target?.dispatchEvent(new DragEvent(kind, { dataTransfer: data, clientX: x, clientY: y, bubbles: true, cancelable: true }));
        }
      },
      { bytes: png, ...place },
    );
    await editor.node('image-file').waitFor();
    expect(await readdir(join(project, 'assets'))).toEqual(['gray.png']);
    expect(await editor.inspector.getByRole('combobox').first().textContent()).toBe('gray.png');
  });
});

describe('values', () => {
  test('are typed with their unit, kept in range, and dragged in one step', async () => {
    const { page, editor } = await start();
    await editor.addNode('gaussian');
    const field = editor.inspector.getByRole('textbox', { name: 'Radius' });
    await field.fill('12 px');
    await page.keyboard.press('Enter');
    expect(await field.inputValue()).toBe('12');
    await field.fill('9999');
    await page.keyboard.press('Enter');
    const most = Number(await field.inputValue());
    expect(most).toBeLessThan(9999);
    await page.keyboard.press('Control+z');
    expect(await field.inputValue()).toBe('12');
    await page.mouse.click(400, 500);
    await editor.node('gaussian').locator('.node-title').click();
    const at = await centerOf(field);
    await editor.drag(at, { x: at.x + 40, y: at.y });
    expect(Number(await field.inputValue())).toBeGreaterThan(12);
    await page.keyboard.press('Control+z');
    expect(await field.inputValue()).toBe('12');
  });

  test('angles are shown in degrees and stored in radians', async () => {
    const open = await start();
    await open.editor.addNode('transform');
    await open.editor.inspector.getByRole('textbox', { name: 'Rotation Y' }).fill('90');
    await open.page.keyboard.press('Enter');
    const { main } = await saveGraphs(open);
    const transform = Object.values(main?.nodes ?? {}).find(({ type }) => type === 'objects/transform');
    expect((Object.values(transform?.params ?? {})[0] as number[])[1]).toBeCloseTo(Math.PI / 2, 9);
  });
});

describe('files', () => {
  test('unsaved work is asked about before another project is opened', async () => {
    const { page, editor } = await start();
    await editor.addNode('sepia');
    await page.keyboard.press('Control+o');
    const dialog = page.getByRole('dialog', { name: /Save the changes/ });
    await dialog.waitFor();
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'detached' });
    expect(await page.locator('.unsaved').count()).toBe(1);
  });

  test('work that was not saved is found again after the page went away', async () => {
    const { page, editor } = await start();
    // It may be kept before the last key has been answered.
    const kept = page.waitForResponse((response) => response.url().endsWith('/project.autosave'));
    await editor.addNode('sepia');
    await kept;
    page.on('dialog', (dialog) => void dialog.accept());
    await page.reload();
    await page.getByRole('dialog', { name: 'Unsaved changes found' }).getByRole('button', { name: 'Restore' }).click();
    await editor.node('sepia').waitFor();
    expect(await page.locator('.unsaved').count()).toBe(1);
  });

  test('a project changed on disk is loaded again, or asked about where there is unsaved work', async () => {
    const { page, editor, project } = await start();
    const path = join(project, 'project.scrim.json');
    const text = await readFile(path, 'utf8');
    await writeFile(path, text.replace('"Test"', '"Changed elsewhere"'));
    await page.getByRole('heading', { name: 'Changed elsewhere' }).waitFor();
    await editor.addNode('sepia');
    await writeFile(path, text.replace('"Test"', '"Changed again"'));
    await page.getByRole('dialog', { name: 'Project changed on disk' }).waitFor();
    await page.getByRole('button', { name: 'Load from disk' }).click();
    await page.getByRole('heading', { name: 'Changed again' }).waitFor();
    expect(await editor.node('sepia').count()).toBe(0);
  });
});

describe('the preview', () => {
  test('comes back after the graphics device was lost, with the same picture', async () => {
    const { page, editor } = await start();
    await editor.settled();
    const before = await editor.rewind();
    const frame = await frameOf(page);
    await frame.evaluate(() => {
      const gl = document.querySelector<HTMLCanvasElement>('#picture')?.getContext('webgl2');
      const extension = gl?.getExtension('WEBGL_lose_context');
      (globalThis as { lost?: WEBGL_lose_context | null }).lost = extension ?? null;
      extension?.loseContext();
    });
    await page.getByText('The graphics device was lost').waitFor();
    await frame.evaluate(() => (globalThis as { lost?: WEBGL_lose_context | null }).lost?.restoreContext());
    await page.getByText('The graphics device was lost').waitFor({ state: 'detached' });
    await editor.imageSameAs(before);
  });

  test('waits to be started where the device was lost the last time, and where Shift was held on opening', async () => {
    const { page, editor } = await start();
    await editor.settled();
    const frame = await frameOf(page);
    await frame.evaluate(() => {
      document.querySelector<HTMLCanvasElement>('#picture')?.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
    });
    await page.getByText('The graphics device was lost').waitFor();
    await page.reload();
    await page.getByText('the graphics device was lost when this project was last open').waitFor();
    expect(await page.locator('iframe[title="Preview"]').count()).toBe(0);
    // The graph can be edited meanwhile.
    await page.locator('.react-flow__node').first().waitFor();
    await page.getByRole('button', { name: 'Start preview' }).click();
    await editor.settled();
    await editor.rewind();
    await page.reload();
    await editor.settled();
    expect(await page.getByRole('button', { name: 'Start preview' }).count()).toBe(0);

    await page.keyboard.press('Control+o');
    await page
      .getByRole('region', { name: 'Recent' })
      .locator('.open-project')
      .first()
      .click({ modifiers: ['Shift'] });
    await page.getByText('Shift was held while the project opened').waitFor();
    await page.getByRole('button', { name: 'Start preview' }).click();
    await editor.settled();
  });

  test('steps frame by frame, and shows two views as a headset does', async () => {
    const { page, editor } = await start();
    await editor.settled();
    await editor.rewind();
    await page.waitForFunction(() => document.querySelector('.transport-time span')?.textContent === '0');
    await editor.press('Next frame');
    await page.waitForFunction(() => document.querySelector('.transport-time span')?.textContent === '1');
    await chooseOption(page.getByRole('combobox', { name: 'Preview source' }), 'room/studio');
    await editor.settled();
    const one = await editor.picture();
    await editor.press('Two views, as in a headset');
    await editor.imageOtherThan(one);
  });
});
