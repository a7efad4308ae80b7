import { createSubgraph } from '../../../export/graph/commands/create-subgraph.ts';
import { makeNodeId, subgraphName, subgraphType } from '../../../export/graph/document-names.ts';
import { DEFAULT_PAGE, EMPTY_GRAPH, EMPTY_LAYOUT, newProject } from '../../../export/graph/new-project.ts';
import { placeNodes } from '../../../export/graph/place-nodes.ts';
import { type ExposedPort, type ExposedPorts, type Graph, MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { RECIPE_GRAPH } from '../../../export/graph/read-recipe.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { diagnosticWithTitles } from '../document/message-titles.ts';
import { graphOf, layoutOf, nodeOf, titleOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';

export type SelectedRecipe = { readonly project: Project } | { readonly problem: string };

/**
 * A recipe with copies of the selected nodes. Its ports are those with a wire to a node outside, required inputs without a wire, and, if
 * nothing outside reads the nodes, the first outputs of those that no other reads. Nodes that need something of the open project are a
 * problem: other projects do not have it.
 */
export function recipeOfSelection(editor: Editor): SelectedRecipe {
  const state = editor.document.getState();
  const { library } = state;
  const nodes = [...editor.selection.getState().nodes].filter((id) => nodeOf(state, id) !== undefined);
  const foreign = nodes.map((id) => foreignProblem(editor, id)).find((problem) => problem !== null);
  if (foreign !== undefined) return { problem: foreign };
  const alone = { ...newProject(''), graphs: { [MAIN_GRAPH]: graphOf(state) }, layout: { [MAIN_GRAPH]: layoutOf(state) } };
  const id = makeNodeId(alone, subgraphType(RECIPE_GRAPH), editor.random);
  const made = createSubgraph(alone, { library, graph: MAIN_GRAPH, nodes, name: RECIPE_GRAPH, id, x: 0, y: 0 });
  const [refusal] = made.diagnostics;
  // The command speaks of the subgraph as which a recipe is stored.
  if (refusal) return { problem: diagnosticWithTitles(state, refusal).message.replaceAll('subgraph', 'recipe') };
  const inside = made.project.graphs[RECIPE_GRAPH] ?? EMPTY_GRAPH;
  const graph = { ...inside, exposed: withOpenPorts(inside, library) };
  return {
    project: {
      ...newProject(''),
      page: DEFAULT_PAGE,
      graphs: {
        [MAIN_GRAPH]: { ...EMPTY_GRAPH, nodes: { [id]: { type: subgraphType(RECIPE_GRAPH), version: 1, params: {} } } },
        [RECIPE_GRAPH]: graph,
      },
      layout: {
        [MAIN_GRAPH]: { ...EMPTY_LAYOUT, nodes: { [id]: { x: 0, y: 0 } } },
        [RECIPE_GRAPH]: { ...EMPTY_LAYOUT, nodes: placesAround(graph, made.project) },
      },
      recipe: { keywords: [] },
    },
  };
}

/** Why a node cannot leave its project; null if it can. */
function foreignProblem({ document, libraries }: Editor, id: string): string | null {
  const state = document.getState();
  const { project, library } = state;
  const node = nodeOf(state, id);
  const title = titleOf(state, id);
  if (!node) return null;
  if (subgraphName(node.type) !== null) return `“${title}” is a subgraph of this project. Ungroup it, or leave it out of the selection.`;
  if (libraries.base.definition(node.type) !== library.definition(node.type))
    return `“${title}” is a shader of this project, which other projects do not have. Leave it out of the selection.`;
  const values = Object.values(node.params).flatMap((binding) => ('value' in binding ? [binding.value] : []));
  const [asset] = Object.keys(project.assets).filter((known) => values.includes(known));
  const path = asset === undefined ? undefined : getOwn(project.assets, asset)?.path;
  if (path === undefined) return null;
  return `“${title}” uses the file ${path} of this project, which other projects do not have. Reset its file, or leave it out of the selection.`;
}

function withOpenPorts({ nodes, wires, exposed }: Graph, library: NodeLibrary): ExposedPorts {
  const taken = new Set([...exposed.inputs, ...exposed.outputs].map(({ name }) => name));
  const named = (node: string, port: string): ExposedPort => {
    let name = port;
    for (let number = 2; taken.has(name); number++) name = `${port}${number}`;
    taken.add(name);
    return { name, node, port };
  };
  const isExposed = (side: keyof ExposedPorts, node: string, port: string) =>
    exposed[side].some((known) => known.node === node && known.port === port);
  const definitions = Object.entries(nodes).map(([id, { type }]) => [id, library.definition(type)] as const);
  const inputs = definitions.flatMap(([node, definition]) =>
    Object.entries(definition?.inputs ?? {})
      .filter(([port, { required }]) => required && !wires.some(({ to }) => to.node === node && to.port === port))
      .flatMap(([port]) => (isExposed('inputs', node, port) ? [] : [named(node, port)])),
  );
  const ends = definitions.filter(([node]) => exposed.outputs.length === 0 && wires.every(({ from }) => from.node !== node));
  const outputs = ends.flatMap(([node, definition]) =>
    Object.keys(definition?.outputs ?? {})
      .slice(0, 1)
      .map((port) => named(node, port)),
  );
  return { inputs: [...exposed.inputs, ...inputs], outputs: [...exposed.outputs, ...outputs] };
}

/** Positions with the node of the first output at the origin, or else the rightmost one: that is where the recipe is put. */
function placesAround(graph: Graph, { layout }: Project) {
  const places = placeNodes(graph, getOwn(layout, RECIPE_GRAPH));
  const rightmost = Object.keys(places).reduce<string | undefined>(
    (best, id) => (best !== undefined && (places[best]?.x ?? 0) >= (places[id]?.x ?? 0) ? best : id),
    undefined,
  );
  const { x, y } = places[graph.exposed.outputs[0]?.node ?? rightmost ?? ''] ?? { x: 0, y: 0 };
  return Object.fromEntries(Object.entries(places).map(([id, place]) => [id, { ...place, x: place.x - x, y: place.y - y }]));
}
