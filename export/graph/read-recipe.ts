import type { Diagnostic, Result } from '../../nodes/kit/diagnostics.ts';
import { subgraphName } from './document-names.ts';
import { loadProject, type ProjectTexts } from './load.ts';
import type { Project } from './project.ts';
import { getOwn } from './record.ts';

/** The subgraph of a recipe project that the palette adds. Its exposed ports are the ports of the recipe. */
export const RECIPE_GRAPH = 'recipe';

/**
 * Reads a recipe: a project with the key `recipe`, whose subgraph `recipe` has the nodes. Shaders, assets and other subgraphs are errors,
 * because the palette adds the nodes to projects that have no such files (SCR002).
 *
 * @returns The project, or null with at least one error: those of `loadProject`, or SCR002. Never throws.
 *
 * @example
 * const { output } = readRecipe(texts);
 * output?.graphs[RECIPE_GRAPH]?.exposed.inputs; // the inputs of the recipe
 */
export function readRecipe(texts: ProjectTexts): Result<Project> {
  const { output: project, diagnostics } = loadProject(texts);
  if (project === null) return { output: null, diagnostics };
  const problems = problemsOf(project).map((message): Diagnostic => ({ code: 'SCR002', severity: 'error', message }));
  return { output: problems.length > 0 ? null : project, diagnostics: [...diagnostics, ...problems] };
}

function problemsOf({ title, graphs, sources, assets, recipe }: Project): readonly string[] {
  const graph = getOwn(graphs, RECIPE_GRAPH);
  if (recipe === undefined) return ['The project is no recipe: the key “recipe” is missing.'];
  if (graph === undefined || Object.keys(graph.nodes).length === 0) return [`The recipe has no nodes in a subgraph “${RECIPE_GRAPH}”.`];
  const inner = Object.values(graph.nodes).find(({ type }) => subgraphName(type) !== null);
  return [
    ...(title.trim() === '' ? ['The recipe has no title.'] : []),
    ...(inner ? [`The recipe contains the subgraph “${subgraphName(inner.type)}”. Ungroup it.`] : []),
    ...Object.keys(sources).map((file) => `The recipe uses the shader “${file}” of a project. Remove it.`),
    ...Object.values(assets).map(({ path }) => `The recipe uses the file “${path}” of a project. Remove it.`),
  ];
}
