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
    await hands.drag('Drag a wire from a port', from, to);
    await hands.type(`“${query}”`, query, page.getByRole('combobox', { name: 'Search nodes' }));
    await node(made).first().waitFor();
  };

  await hands.click('New project', page.getByRole('button', { name: 'New project: Empty' }));
  await hands.type('Its folder', project, field('Folder'));
  await node('screen').waitFor();
  const canvas = await page.locator('.canvas').boundingBox();
  if (!canvas) throw new Error('There is no canvas.');
  const at = (x: number, y: number): Point => ({ x: canvas.x + x, y: canvas.y + y });

  /** A point on a wire, which is symmetric about its middle. */
  const onWire = (from: Point, to: Point, part = 0.5): Point => ({
    x: from.x + part * (to.x - from.x),
    y: from.y + part * (to.y - from.y),
  });
  /** Selects a wire, and inserts the node that the query finds. */
  const insert = async (from: Point, to: Point, query: string, made: string) => {
    await hands.clickAt('Select a wire', onWire(from, to));
    await hands.press('Add a node: Tab', 'Tab');
    await hands.type(`“${query}”`, query, page.getByRole('combobox', { name: 'Search nodes' }));
    await node(made).first().waitFor();
  };

  await hands.dropFile('Drop a model', model, at(30, 330));
  await node('scene').waitFor();
  await hands.type('To the right: 0.3 m', '0.3', field('Position X'));
  await hands.type('Away: −0.85 m', '-0.85', field('Position Z'));
  await hands.type('Larger: 2.2', '2.2', field('Scale'));
  await insert(await output('transform', 'objects'), await input('scene', 'objects'), 'cartoon', 'apply');
  await insert(await output('scene', 'layer'), await input('over', 'top'), 'depth occlusion', 'depth-occlusion');
  await grow(await output('transform', 'objects'), at(430, 700), 'shadow on floor', 'shadow');
  const clipped = await port(page.locator('[data-node^="depth-occlusion"]').last(), 'layer', 'source');
  const video = onWire(await output('video', 'layer'), await input('over', 'bottom'), 0.4);
  await hands.drag('Composite it under the model', clipped, video);
  await page.waitForFunction(() => document.querySelectorAll('[data-node^="over"]').length === 2);
  await hands.press('Tidy up: L', 'l');

  await hands.click('Export', button('Export'));
  await hands.type('Its folder', exportTo, field('Folder'));
  await page.getByText(/^Exported to/).waitFor({ timeout: EXPORT_MS });
  return hands.done;
}
