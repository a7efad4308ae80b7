import { freePointOnWire, type NewcomerOptions, startWithModel } from './editor-steps.ts';
import type { Interaction } from './hands.ts';

/**
 * Goes from no project to an exported page, by pointer and keys alone. The page shows a model in cartoon colors in the room, hidden by real
 * objects in front of it, with its shadow on the floor. Returns the interactions in order.
 */
export async function playNewcomer(options: NewcomerOptions): Promise<readonly Interaction[]> {
  const { hands, at, ...steps } = await startWithModel(options);
  const { field, output, input } = steps;
  await hands.type('To the right: 0.3 m', '0.3', field('Position X'));
  await hands.type('Away: −0.85 m', '-0.85', field('Position Z'));
  await hands.type('Larger: 2.2', '2.2', field('Scale'));
  await steps.insert(await output('transform', 'objects'), await input('scene', 'objects'), 'cartoon', 'apply');
  await steps.insert(await output('scene', 'layer'), await input('over', 'top'), 'depth occlusion', 'depth-occlusion');
  await steps.grow(await output('transform', 'objects'), at(430, 700), 'shadow on floor', 'shadow');
  const clipped = await steps.port(options.page.locator('[data-node^="depth-occlusion"]').last(), 'layer', 'source');
  const video = await freePointOnWire(options.page, 'video', 'bottom');
  await hands.drag('Composite it under the model', clipped, video);
  await options.page.waitForFunction(() => document.querySelectorAll('[data-node^="over"]').length === 2);
  await steps.exportTo(options.exportTo);
  return hands.done;
}
