import { readdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { centerOf } from '../../tools/lib/center-of.ts';
import { dropFiles } from '../support/drop-files.ts';
import { dropModel } from '../support/drop-model.ts';
import { EditorDriver } from '../support/editor-driver.ts';
import { encodeImage } from '../support/image.ts';
import { type GraphText, useEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { describeWithData } from '../support/shared-data.ts';

const GRAPH: GraphText = {
  nodes: { 'camera-aaaa': { type: 'source/camera-video' }, 'screen-aaaa': { type: 'output/screen' } },
  wires: ['camera-aaaa.layer -> screen-aaaa.layer'],
  places: { 'camera-aaaa': [0, 0], 'screen-aaaa': [320, 0] },
};

const open = useEditor();

test('files are taken everywhere in the window, and the canvas shows their nodes beside the others', async () => {
  const { page, editor, project } = await open(GRAPH);
  await editor.settled();
  const picture = join(project, 'gray.png');
  await writeFile(picture, encodeImage({ width: 2, height: 2, data: new Uint8Array(16).fill(200) }));
  const address = page.url();
  const preview = page.locator('iframe[title="Preview"]');
  const target = page.locator('.picture-drop');
  const places = [
    // The preview is a frame in a process of its own.
    await centerOf(preview),
    await centerOf(editor.inspector),
    await centerOf(page.locator('.top-bar')),
  ];
  for (const [index, at] of places.entries()) {
    await dropFiles(page, [picture], at, () => expect(target.isVisible()).resolves.toBe(true));
    await eventually(async () => expect(await editor.node('image-file').count()).toBe(index + 1));
    await target.waitFor({ state: 'detached' });
  }
  expect(page.url()).toBe(address);
  expect(page.context().pages()).toHaveLength(1);
  expect((await readdir(join(project, 'assets'))).length).toBeGreaterThan(0);
  // None covers another, and all are seen.
  const canvas = await page.locator('.canvas').boundingBox();
  const boxes = await page.locator('.react-flow__node').evaluateAll((nodes) => nodes.map((node) => node.getBoundingClientRect().toJSON()));
  expect(boxes).toHaveLength(5);
  for (const a of boxes) {
    expect(a.left).toBeGreaterThan(canvas?.x ?? 0);
    expect(a.bottom).toBeLessThan((canvas?.y ?? 0) + (canvas?.height ?? 0));
    expect(boxes.filter((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)).toEqual([a]);
  }
});

test('nothing is added behind a dialog', async () => {
  const { page, editor, project } = await open(GRAPH);
  const picture = join(project, 'gray.png');
  await writeFile(picture, encodeImage({ width: 2, height: 2, data: new Uint8Array(16).fill(200) }));
  const address = page.url();
  await page.keyboard.press('?');
  await page.getByRole('dialog').waitFor();
  await dropFiles(page, [picture], await centerOf(editor.inspector));
  await page.keyboard.press('Escape');
  await page.getByRole('dialog').waitFor({ state: 'detached' });
  // A later drop is taken, so an earlier one would have been, too.
  await dropFiles(page, [picture], await centerOf(editor.inspector));
  await editor.node('image-file').waitFor();
  expect(await editor.node('image-file').count()).toBe(1);
  expect(page.url()).toBe(address);
});

test('a window of the preview takes files beside the picture, too', async () => {
  const { page, editor, project } = await open(GRAPH);
  const picture = join(project, 'gray.png');
  await writeFile(picture, encodeImage({ width: 2, height: 2, data: new Uint8Array(16).fill(200) }));
  await editor.press('Phone, portrait');
  const popup = await editor.popOut();
  const frame = await popup.locator('iframe[title="Preview"]').boundingBox();
  if (!frame) throw new Error('The window has no preview.');
  const pages = page.context().pages().length;
  const target = popup.locator('.picture-drop');
  for (const [index, at] of [
    { x: 8, y: 8 },
    { x: frame.x + 20, y: frame.y + 100 },
  ].entries()) {
    await dropFiles(popup, [picture], at, () => expect(target.isVisible()).resolves.toBe(true));
    await eventually(async () => expect(await editor.node('image-file').count()).toBe(index + 1));
    await target.waitFor({ state: 'detached' });
  }
  expect(popup.url()).toBe('about:blank');
  expect(page.context().pages()).toHaveLength(pages);
});

describeWithData('a real model', 'models/Fox.glb', (fox) => {
  test('stands on the floor where it is dropped on the picture, in a size that is seen; one undo takes all back', async () => {
    const { page, editor } = await open(GRAPH);
    const empty = await editor.rewind();
    const { left, right, count } = await dropModel(page, fox, empty);
    // It is 154 units long.
    expect(count).toBeGreaterThan(500);
    expect(right - left).toBeLessThan(empty.width * 0.7);
    await page.locator('.canvas').focus();
    await page.keyboard.press('Control+z');
    await editor.node('transform').waitFor({ state: 'detached' });
    // Only nodes in view are mounted.
    await page.keyboard.press('f');
    await eventually(async () => expect(await page.locator('.react-flow__node').count()).toBe(2));
    await editor.imageSameAs(empty);
  });

  test('stands so in the window of the preview, whose keys undo it', async () => {
    const { editor } = await open(GRAPH);
    await editor.rewind();
    const popup = await editor.popOut();
    const empty = await new EditorDriver(popup).restingImage();
    await dropModel(popup, fox, empty);
    await popup.keyboard.press('Control+z');
    await editor.node('transform').waitFor({ state: 'detached' });
    await new EditorDriver(popup).imageSameAs(empty);
  });
});
