import { createEditorSteps, type NewcomerOptions } from './editor-steps.ts';
import { Hands, type Interaction } from './hands.ts';

/** Creates a project and a new filter in it, and types a line of GLSL into the filter. Returns the interactions in order. */
export async function playFilter({
  page,
  project,
  onDone,
}: Pick<NewcomerOptions, 'page' | 'project' | 'onDone'>): Promise<readonly Interaction[]> {
  const hands = new Hands(page, onDone ?? (async () => {}));
  const steps = createEditorSteps(page, hands);
  await steps.newProject(project);
  await hands.click('The menu Graph', page.getByRole('button', { name: 'Graph', exact: true }));
  await hands.click('New filter', page.getByRole('menuitem', { name: 'New filter' }));
  await steps.node('my-filter').waitFor();
  await hands.click('Into the line of the color', page.locator('.monaco-editor .view-line', { hasText: /vec3\s+tinted/ }));
  await page.locator('.monaco-editor.focused').waitFor();
  await hands.press('Its start', 'Home');
  await hands.press('To its end', 'Shift+End');
  await hands.write('Another color', 'vec3 tinted = color.rgb * vec3(0.1, 0.3, 1.0);');
  return hands.done;
}
