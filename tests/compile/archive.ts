import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { migrateNodes, migrationsOf } from '../../export/graph/library/migrate-nodes.ts';
import type { ProjectTexts } from '../../export/graph/load.ts';
import type { Project } from '../../export/graph/project.ts';
import type { NodeDefinition, NodeLibrary } from '../../nodes/kit/definition.ts';
import { TESTS_FOLDER } from '../support/this-test.ts';

/** A project as some released version of the document saved it, `vN` for version N. It is never saved again. */
export interface ArchivedProject {
  readonly name: string;
  readonly texts: ProjectTexts;
}

export async function readArchive(): Promise<ArchivedProject[]> {
  const folder = join(TESTS_FOLDER, 'compile', 'archive');
  const names = (await readdir(folder)).sort();
  return Promise.all(names.map(async (name) => ({ name, texts: await readProject(join(folder, name)) })));
}

async function readProject(folder: string): Promise<ProjectTexts> {
  const shaders = await readdir(join(folder, 'shaders')).catch((): string[] => []);
  const sources = await Promise.all(shaders.map(async (file) => [file, await readFile(join(folder, 'shaders', file), 'utf8')] as const));
  return {
    project: await readFile(join(folder, 'project.scrim.json'), 'utf8'),
    layout: await readFile(join(folder, 'project.layout.json'), 'utf8').catch(() => null),
    sources: Object.fromEntries(sources),
  };
}

/** Steps of node types that no archived project takes, as `type from-to`; those that a type should have and has not, too. */
export function stepsNeverTaken(library: NodeLibrary, projects: readonly Project[]): string[] {
  const taken = new Set<string>();
  const stepName = (type: string, from: number) => `${type} ${from}-${from + 1}`;
  const watched = (definition: NodeDefinition): NodeDefinition => ({
    ...definition,
    migrations: migrationsOf(definition).map((step, index) => (params) => {
      taken.add(stepName(definition.type, index + 1));
      return step(params);
    }),
  });
  const watching: NodeLibrary = {
    ...library,
    definition: (type) => {
      const definition = library.definition(type);
      return definition && watched(definition);
    },
  };
  for (const project of projects) migrateNodes(project, watching);
  return [...library.types()].flatMap((type) => {
    const newest = library.definition(type)?.version ?? 1;
    const steps = Math.max(newest - 1, stepCount(library.definition(type)));
    const names = Array.from({ length: steps }, (_, index) => stepName(type, index + 1));
    return names.filter((name) => !taken.has(name));
  });
}

function stepCount(definition: NodeDefinition | undefined): number {
  return definition === undefined ? 0 : migrationsOf(definition).length;
}
