import type { Locator, Page } from 'playwright-core';
import { centerOf, type Point } from '../lib/center-of.ts';
import { Hands, type Interaction } from './hands.ts';

export interface NewcomerOptions {
  /** The editor without an open project, 1440 × 900. */
  readonly page: Page;
  /** Path of the model that is dropped. */
  readonly model: string;
  /** Folders that do not exist yet. */
  readonly project: string;
  readonly exportTo: string;
  readonly onDone?: (done: Interaction) => Promise<void>;
}

const EXPORT_MS = 300_000;

/**
 * From no project to an exported page: a model that stands in the room in cartoon colors, hidden by what is before it, with its
 * shadow on the floor. By pointer and keys alone; gives what was done, in order.
 */
export async function playNewcomer({ page, model, project, exportTo, onDone }: NewcomerOptions): Promise<readonly Interaction[]> {
  const hands = new Hands(page, onDone ?? (async () => {}));
  const button = (name: string) => page.getByRole('button', { name, exact: true });
  const field = (name: string) => page.getByRole('textbox', { name, exact: true });
  const node = (stem: string) => page.locator(`[data-node^="${stem}"]`);
  const port = async (owner: Locator, name: string, side: 'source' | 'target'): Promise<Point> => {
    const id = await owner.first().getAttribute('data-node');
    return centerOf(page.locator(`.react-flow__handle.${side}[data-nodeid="${id}"][data-handleid="${name}"]`));
  };
  const output = (stem: string, name: string) => port(node(stem), name, 'source');
  const input = (stem: string, name: string) => port(node(stem), name, 'target');
  /** Drags a wire from a port onto the empty canvas, and adds the node that the query finds. */
  const grow = async (from: Point, to: Point, query: string, made: string) => {
    await hands.drag('Pull a wire out of a port', from, to);
    await hands.type(`“${query}”`, query, page.getByRole('combobox', { name: 'Search nodes' }));
    await node(made).first().waitFor();
  };

  await hands.click('New project', page.getByRole('button', { name: 'New project: Empty' }));
  await hands.type('Its folder', project, field('Folder'));
  await node('screen').waitFor();
  const canvas = await page.locator('.canvas').boundingBox();
  if (!canvas) throw new Error('There is no canvas.');
  const at = (x: number, y: number): Point => ({ x: canvas.x + x, y: canvas.y + y });

  await hands.dropFile('Drop a model', model, at(30, 50));
  await grow(await output('model', 'objects'), at(280, 98), 'transform', 'transform');
  await hands.type('To the right: 0.3 m', '0.3', field('Position X'));
  await hands.type('Away: −0.85 m', '-0.85', field('Position Z'));
  await hands.type('Larger: 2.2', '2.2', field('Scale'));
  await grow(await output('transform', 'objects'), at(530, 98), 'cartoon', 'apply');
  await grow(await output('apply', 'objects'), at(780, 98), 'scene', 'scene');
  await grow(await input('scene', 'lights'), at(720, 230), 'directional', 'directional');
  await hands.type('From the left: −110°', '-110', field('Azimuth'));
  await grow(await output('scene', 'layer'), at(800, 310), 'occlusion', 'depth-occlusion');

  /** A point on a wire between the camera and the Output. */
  const onWire = (from: Point, to: Point, part: number) => ({ x: from.x + part * (to.x - from.x), y: from.y + part * (to.y - from.y) });
  const toScreen = onWire(await output('video', 'layer'), await input('screen', 'layer'), 0.75);
  await hands.drag('Lay it over the video', await output('depth-occlusion', 'layer'), toScreen);
  await node('over').waitFor();
  await grow(await output('transform', 'objects'), at(480, 620), 'shadow on floor', 'shadow');
  const clipped = await port(page.locator('[data-node^="depth-occlusion"]').last(), 'layer', 'source');
  await hands.drag('Lay it under', clipped, onWire(await output('video', 'layer'), await input('over', 'bottom'), 0.4));
  await page.waitForFunction(() => document.querySelectorAll('[data-node^="over"]').length === 2);
  await hands.press('Tidy up: L', 'l');

  await hands.click('Export', button('Export'));
  await hands.type('Its folder', exportTo, field('Folder'));
  await page.getByText(/^Exported to/).waitFor({ timeout: EXPORT_MS });
  return hands.done;
}
