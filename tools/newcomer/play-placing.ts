import type { Locator } from 'playwright-core';
import { centerOf, type Point } from '../lib/center-of.ts';
import { Hands, type Interaction } from './hands.ts';
import type { NewcomerOptions } from './play-newcomer.ts';

const EXPORT_MS = 300_000;

/**
 * From no project to an exported page in which the visitor places a model by a tap, drags, turns and scales it, and measures from it by
 * further taps. By pointer and keys alone; gives what was done, in order.
 */
export async function playPlacing({ page, model, project, exportTo, onDone }: NewcomerOptions): Promise<readonly Interaction[]> {
  const hands = new Hands(page, onDone ?? (async () => {}));
  const field = (name: string) => page.getByRole('textbox', { name, exact: true });
  const node = (stem: string) => page.locator(`[data-node^="${stem}"]`);
  const port = async (owner: Locator, name: string, side: 'source' | 'target'): Promise<Point> => {
    const id = await owner.first().getAttribute('data-node');
    return centerOf(page.locator(`.react-flow__handle.${side}[data-nodeid="${id}"][data-handleid="${name}"]`));
  };
  const output = (stem: string, name: string) => port(node(stem), name, 'source');
  const input = (stem: string, name: string) => port(node(stem), name, 'target');
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

  await hands.dropFile('Drop a model', model, at(30, 330));
  await node('scene').waitFor();
  await hands.type('Where the tap is: 0 m', '0', field('Position Z'));
  const [from, to] = [await output('transform', 'objects'), await input('scene', 'objects')];
  await hands.clickAt('Select a wire', { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 });
  await hands.press('Add a node: Tab', 'Tab');
  await hands.type('“place”', 'place', page.getByRole('combobox', { name: 'Search nodes' }));
  await node('place').waitFor();
  await hands.choose('A tap places it once', page.getByRole('combobox', { name: 'Taps', exact: true }), 'Place once');
  await grow(await input('scene', 'objects'), at(330, 700), 'measure', 'measure');
  await hands.choose('Further taps measure', page.getByRole('combobox', { name: 'Points', exact: true }), 'Taps');

  await hands.click('Export', page.getByRole('button', { name: 'Export', exact: true }));
  await hands.type('Its folder', exportTo, field('Folder'));
  await page.getByText(/^Exported to/).waitFor({ timeout: EXPORT_MS });
  return hands.done;
}
