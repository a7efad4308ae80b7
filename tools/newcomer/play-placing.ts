import { createEditorSteps, type NewcomerOptions } from './editor-steps.ts';
import { Hands, type Interaction } from './hands.ts';

/**
 * From no project to an exported page in which the visitor places a model by a tap, drags, turns and scales it, and measures from it by
 * further taps. By pointer and keys alone; gives what was done, in order.
 */
export async function playPlacing({ page, model, project, exportTo, onDone }: NewcomerOptions): Promise<readonly Interaction[]> {
  const hands = new Hands(page, onDone ?? (async () => {}));
  const steps = createEditorSteps(page, hands);
  const { field, node, output, input } = steps;
  const at = await steps.newProject(project);
  await hands.dropFile('Drop a model', model, at(30, 330));
  await node('scene').waitFor();
  await hands.type('Where the tap is: 0 m', '0', field('Position Z'));
  await steps.insert(await output('transform', 'objects'), await input('scene', 'objects'), 'place', 'place');
  await hands.choose('A tap places it once', page.getByRole('combobox', { name: 'Taps', exact: true }), 'Place once');
  await steps.grow(await input('scene', 'objects'), at(330, 700), 'measure', 'measure');
  await hands.choose('Further taps measure', page.getByRole('combobox', { name: 'Points', exact: true }), 'Taps');
  await steps.exportTo(exportTo);
  return hands.done;
}
