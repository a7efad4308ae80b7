import type { Page } from 'playwright-core';
import { centerOf, type Point } from '../lib/center-of.ts';
import { type NewcomerOptions, startWithModel } from './editor-steps.ts';
import { Hands, type Interaction } from './hands.ts';

/**
 * Goes from no project to an exported page, by pointer and keys alone. In the page the visitor places a model by a tap, drags, rotates and
 * scales it, measures a distance from it by further taps, and reads the length on a label. Returns the interactions in order.
 */
export async function playPlacing(options: NewcomerOptions): Promise<readonly Interaction[]> {
  const { hands, at, ...steps } = await startWithModel(options);
  const { field, node, output, input } = steps;
  await hands.type('Where the tap is: 0 m to the right', '0', field('Position X'));
  await hands.type('0 m away', '0', field('Position Z'));
  await steps.insert(await output('transform', 'objects'), await input('scene', 'objects'), 'place', 'place');
  await hands.choose('A tap places it once', options.page.getByRole('combobox', { name: 'Taps', exact: true }), 'Place once');
  await steps.grow(await input('scene', 'objects'), at(330, 700), 'measure', 'measure');
  await hands.choose('Further taps measure', options.page.getByRole('combobox', { name: 'Points', exact: true }), 'Taps');
  await steps.grow(await output('measure', 'pose'), at(560, 700), 'label', 'label');
  await hands.drag('The label shows the length', await output('measure', 'text'), await centerOf(node('label')));
  await hands.drag('Draw the label', await output('label', 'objects'), await input('scene', 'objects'));
  await steps.exportTo(options.exportTo);
  return hands.done;
}

/** Uses the finished graph in the preview as a visitor would: places the model, drags and turns it, and measures from its first position. */
export async function tryPlacing(page: Page, onDone: (done: Interaction) => Promise<void>): Promise<void> {
  const hands = new Hands(page, onDone);
  const box = await page.locator('.stage-frame').boundingBox();
  if (!box) throw new Error('There is no preview.');
  const at = (x: number, y: number): Point => ({ x: box.x + x * box.width, y: box.y + y * box.height });
  await hands.clickAt('Tap: the model is placed', at(0.4, 0.9));
  await hands.drag('Drag it along the floor', at(0.4, 0.88), at(0.25, 0.85));
  const frame = Math.min(box.width, box.height);
  await hands.twist('Two fingers turn it', at(0.25, 0.77), 0.03 * frame, Math.PI / 2);
  await hands.clickAt('Tap: the length is measured', at(0.8, 0.9));
}
