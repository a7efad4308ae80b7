import { describe, expect, test } from '@jest/globals';
import { readDefinition } from '../../export/glsl/read-definition.ts';
import { forkShader } from '../../export/graph/commands/shader-commands.ts';
import { loadProject } from '../../export/graph/load.ts';
import { saveProject } from '../../export/graph/save.ts';
import { validateProject } from '../../export/graph/validate/validate.ts';
import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import { surround } from '../../tools/new-node/surround.ts';
import { LIBRARY } from '../support/library.ts';
import { definitionProblems } from '../support/node-contract.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';

/** A filter or a technique is one file: what a node folder brings beside its definition is made here. */
const FILES = Object.keys(SHADERS).filter((name) => /^(filters|operators|generators|techniques)\//.test(name));

describe.each(FILES)('shader-library/%s', (file) => {
  const definition = DEFINITIONS.find(({ lowering }) => 'shader' in lowering && lowering.shader === file);

  test('is a node type, documented, consistent and in range', () => {
    if (!definition) throw new Error('It has no definition: `npm run gen` says why.');
    expect(definitionProblems(definition, (name) => Object.hasOwn(SHADERS, name))).toEqual([]);
  });

  test('says what it does and whose it is', () => {
    const { output } = readDefinition(SHADERS[file] ?? '', file);
    expect(output?.doc).not.toBe('');
    expect(output?.credit).toMatch(/Scrim/);
  });

  test('stands in a project without mistakes, which survives saving', () => {
    const project = surround(LIBRARY, definition?.type ?? '', file);
    expect(validateProject(project, LIBRARY)).toEqual([]);
    expect(loadProject(saveProject(project))).toEqual({ output: project, diagnostics: [] });
  });
});

test('there are ISF files and techniques', () => {
  expect(FILES).toEqual(expect.arrayContaining(['filters/sepia.fs', 'techniques/gooch.glsl']));
});

test('a technique is copied into a project as a filter is, and the copy can be edited', () => {
  const studio = new TestStudio({ library: LIBRARY, readShader }).add('look-a', 'technique/gooch', { highlight: 0.2 });
  studio.run((project) => forkShader(project, { library: studio.library, graph: 'main', node: 'look-a' }));
  expect(Object.keys(studio.project.sources)).toEqual(['gooch-2.glsl']);
  expect(studio.project.graphs.main?.nodes['look-a']).toMatchObject({ type: 'technique/gooch-2', params: { highlight: { value: 0.2 } } });
  const shorter = (studio.project.sources['gooch-2.glsl'] ?? '').replace(/.*"NAME": "highlight".*\n/, '');
  studio.source('gooch-2.glsl', shorter);
  expect(studio.project.graphs.main?.nodes['look-a']?.params).toEqual({});
  expect(studio.library.definition('technique/gooch-2')?.params.highlight).toBeUndefined();
  studio.undo();
  expect(studio.project.graphs.main?.nodes['look-a']).toMatchObject({ params: { highlight: { value: 0.2 } } });
  expect(
    studio
      .reopen()
      .diagnostics()
      .filter(({ severity }) => severity === 'error')
      .map(({ code }) => code),
  ).not.toContain('SCR010');
});
