import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { LAYOUT_FORMAT, newestVersion, PROJECT_FORMAT } from '../../export/graph/document/migrate-document.ts';
import { migrateNodes } from '../../export/graph/library/migrate-nodes.ts';
import { loadProject } from '../../export/graph/load.ts';
import { newProject } from '../../export/graph/new-project.ts';
import type { Project } from '../../export/graph/project.ts';
import { saveProject } from '../../export/graph/save.ts';
import { libraryOf, type NodeDefinition } from '../../nodes/kit/definition.ts';
import { LIBRARY } from '../support/library.ts';
import { type ArchivedProject, readArchive, stepsNeverTaken } from './archive.ts';

const archive = await readArchive();
const versionOf = ({ name }: ArchivedProject) => Number(name.slice(1));

function load({ texts }: ArchivedProject): Project {
  const { output, diagnostics } = loadProject(texts);
  expect(diagnostics).toEqual([]);
  if (output === null) throw new Error('not loaded');
  return output;
}

describe.each(archive.map((entry) => [entry.name, entry] as const))('a project of document version %s', (_, entry) => {
  test('loads without a word, and is saved in the newest version', () => {
    const project = load(entry);
    expect(loadProject(saveProject(project))).toEqual({ output: project, diagnostics: [] });
    const newest = [PROJECT_FORMAT, LAYOUT_FORMAT].every((format) => newestVersion(format) === versionOf(entry));
    if (newest) expect(saveProject(project)).toEqual(entry.texts);
  });

  test('compiles', () => {
    const { output, diagnostics } = compile({ project: load(entry), library: LIBRARY });
    expect(diagnostics.filter(({ severity }) => severity === 'error')).toEqual([]);
    expect(output?.operations.length).toBeGreaterThan(5);
  });

  test('has its nodes in the versions of today once they are migrated', () => {
    const { project, diagnostics } = migrateNodes(load(entry), LIBRARY);
    expect(diagnostics).toEqual([]);
    for (const { nodes } of Object.values(project.graphs)) {
      for (const { type, version } of Object.values(nodes)) expect(LIBRARY.definition(type)?.version ?? version).toBe(version);
    }
  });
});

describe('every migration has been taken by an archived project', () => {
  test('of the document', () => {
    const versions = archive.map(versionOf);
    const released = Math.max(newestVersion(PROJECT_FORMAT), newestVersion(LAYOUT_FORMAT));
    expect(versions).toEqual(Array.from({ length: released }, (_, i) => i + 1));
  });

  test('of node types', () => {
    expect(stepsNeverTaken(LIBRARY, archive.map(load))).toEqual([]);
  });

  test('and one that has not would be named', () => {
    const definition = { ...LIBRARY.definition('value/number'), version: 3, migrations: [(params) => params] } as NodeDefinition;
    const main = {
      nodes: { 'number-a': { type: 'value/number', version: 1, params: {} } },
      wires: [],
      exposed: { inputs: [], outputs: [] },
    };
    const empty = newProject('');
    expect(stepsNeverTaken(libraryOf([definition], {}), [empty])).toEqual(['value/number 1-2', 'value/number 2-3']);
    const second = { ...definition, version: 2 };
    expect(stepsNeverTaken(libraryOf([second], {}), [{ ...empty, graphs: { main } }])).toEqual([]);
  });
});
