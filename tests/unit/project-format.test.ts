import { readFileSync } from 'node:fs';
import { expect, test } from '@jest/globals';
import { loadProject } from '../../export/graph/load.ts';
import { saveProject } from '../../export/graph/save.ts';
import { validateProject } from '../../export/graph/validate/validate.ts';
import { LIBRARY } from '../support/library.ts';

test('the files in docs/PROJECT-FORMAT.md are a project without mistakes, and are saved with the same keys', () => {
  const text = readFileSync('docs/PROJECT-FORMAT.md', 'utf8');
  const [project = '', layout = ''] = [...text.matchAll(/```json\n([\s\S]*?)```/g)].map((match) => match[1] ?? '');
  const { output, diagnostics } = loadProject({ project, layout, sources: {} });
  expect(diagnostics).toEqual([]);
  if (!output) throw new Error('The project cannot be read.');
  expect(validateProject(output, LIBRARY)).toEqual([]);
  const saved = saveProject(output);
  expect(JSON.parse(saved.project)).toEqual(JSON.parse(project));
  expect(JSON.parse(saved.layout)).toEqual(JSON.parse(layout));
});
