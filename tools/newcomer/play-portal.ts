import { createEditorSteps, type NewcomerOptions } from './editor-steps.ts';
import { Hands, type Interaction } from './hands.ts';

/**
 * Goes from no project to an exported page with a portal: an object of the room through which the room looks different. Returns the
 * interactions in order.
 */
export async function playPortal({ page, project, exportTo, onDone }: Omit<NewcomerOptions, 'model'>): Promise<readonly Interaction[]> {
  const hands = new Hands(page, onDone ?? (async () => {}));
  const steps = createEditorSteps(page, hands);
  const { output, input, field } = steps;
  const at = await steps.newProject(project);
  await steps.insert(await output('video', 'layer'), await input('screen', 'layer'), 'matte', 'choose-by-mask');
  await hands.drag('Outside the portal: the camera', await output('video', 'layer'), await input('choose-by-mask', 'outside'));
  await steps.insert(await output('video', 'layer'), await input('choose-by-mask', 'inside'), 'posterize', 'posterize');
  await steps.grow(await input('choose-by-mask', 'mask'), at(330, 560), 'object mask', 'object-mask');
  await steps.grow(await input('object-mask', 'objects'), at(60, 700), 'primitive', 'primitive');
  await steps.insert(await output('primitive', 'objects'), await input('object-mask', 'objects'), 'transform', 'transform');
  await hands.type('Away: −0.85 m', '-0.85', field('Position Z'));
  await hands.type('Larger: 2', '2', field('Scale'));
  await steps.exportTo(exportTo);
  return hands.done;
}
