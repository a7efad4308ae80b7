import { describe, expect, test } from '@jest/globals';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { loadProject } from '../../export/graph/load.ts';
import { saveProject } from '../../export/graph/save.ts';
import { validateProject } from '../../export/graph/validate/validate.ts';
import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import { surround } from '../../tools/new-node/surround.ts';
import { LIBRARY } from '../support/library.ts';
import { definitionProblems } from '../support/node-contract.ts';

/** A filter is one file: what a node folder brings beside its definition is made here. */
const FILES = Object.keys(SHADERS).filter((name) => /^(filters|operators|generators)\/.*\.fs$/.test(name));

describe.each(FILES)('shader-library/%s', (file) => {
  const definition = DEFINITIONS.find(({ lowering }) => lowering.kind === 'image' && lowering.shader === file);

  test('is a node type, documented, consistent and in range', () => {
    if (!definition) throw new Error('It has no definition: `npm run gen` says why.');
    expect(definitionProblems(definition, (name) => Object.hasOwn(SHADERS, name))).toEqual([]);
  });

  test('says what it does and whose it is', () => {
    const { output } = readIsf(SHADERS[file] ?? '', file);
    expect(output?.description).not.toBe('');
    expect(output?.credit).not.toBe('');
  });

  test('stands in a project without mistakes, which survives saving', () => {
    const project = surround(LIBRARY, definition?.type ?? '', file);
    expect(validateProject(project, LIBRARY)).toEqual([]);
    expect(loadProject(saveProject(project))).toEqual({ output: project, diagnostics: [] });
  });
});

test('there are ISF files', () => {
  expect(FILES).toContain('filters/sepia.fs');
});
