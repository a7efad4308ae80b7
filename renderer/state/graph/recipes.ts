import { subgraphType } from '../../../export/graph/document-names.ts';
import { migrateNodes } from '../../../export/graph/library/migrate-nodes.ts';
import { createInterfaceLookup } from '../../../export/graph/library/node-interface.ts';
import { EMPTY_LAYOUT } from '../../../export/graph/new-project.ts';
import { placeNodes } from '../../../export/graph/place-nodes.ts';
import type { Graph, GraphLayout, GraphNode, NodeLayout, Project, Wire } from '../../../export/graph/project.ts';
import { RECIPE_GRAPH, readRecipe } from '../../../export/graph/read-recipe.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { RECIPES } from '../../../nodes/generated/recipes.gen.ts';
import { defineNode, type NodeDefinition, type NodeLibrary } from '../../../nodes/kit/definition.ts';
import { formatDiagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { Editor } from '../editor/editor.ts';
import type { OwnRecipe } from '../editor/recipe-state.ts';
import { factsOf, type RecipeFacts } from './recipe-facts.ts';
import { COLUMN_PX } from './show-layer.ts';

/** Several connected nodes that are added as one entry of the palette. After that they are ordinary nodes. */
export interface Recipe extends RecipeFacts {
  /** Palette entry. Its type is `combination/NAME`; its ports are the keys of `ports`. */
  readonly definition: NodeDefinition;
  /** Nodes of the recipe by id. Ids are valid only inside the recipe. */
  readonly nodes: Readonly<Record<string, GraphNode & NodeLayout>>;
  readonly wires: readonly Wire[];
  /** Ports of the palette entry: for each, the port `node.port` inside the recipe. */
  readonly ports: Readonly<Record<string, string>>;
  /** The node that is put at the chosen position and selected: the one nearest to the origin of the layout. */
  readonly main: string;
}

const CATEGORY = 'combination/';
/** Distance between the rows of a recipe, in canvas units. */
export const ROW_PX = 120;

/**
 * All recipes whose node types exist in the library: those of Scrim, one per technique that applies it to objects, and those of the person.
 */
export function recipesOf(library: NodeLibrary, own: readonly OwnRecipe[] = []): readonly Recipe[] {
  return [...builtInRecipes(library), ...own.flatMap(({ name, project }) => toRecipe(library, `${CATEGORY}own-${name}`, project) ?? [])];
}

/** The recipe of a palette entry; undefined if its type is a node type. */
export function recipeOfEntry({ document, recipes }: Pick<Editor, 'document' | 'recipes'>, type: string): Recipe | undefined {
  if (!type.startsWith(CATEGORY)) return undefined;
  return recipesOf(document.getState().library, recipes.getState().own).find(({ definition }) => definition.type === type);
}

const cached = new WeakMap<NodeLibrary, readonly Recipe[]>();

function builtInRecipes(library: NodeLibrary): readonly Recipe[] {
  const known = cached.get(library);
  if (known) return known;
  const shipped = Object.entries(RECIPES).map(([name, texts]) => {
    const { output, diagnostics } = readRecipe({ ...texts, sources: {} });
    if (output === null) throw new Error(`The recipe ${name} is broken: ${diagnostics.map(formatDiagnostic).join(' ')}`);
    return toRecipe(library, `${CATEGORY}${name}`, output);
  });
  const techniques = [...library.types()].flatMap((type) => {
    const definition = library.definition(type);
    return definition?.lowering.kind === 'technique' ? [appliedTechnique(library, definition)] : [];
  });
  const recipes = [...shipped, ...techniques].flatMap((recipe) => recipe ?? []);
  cached.set(library, recipes);
  return recipes;
}

/**
 * A recipe from its project, or null if the library lacks one of its node types.
 *
 * @param type Type of its palette entry.
 */
function toRecipe(library: NodeLibrary, type: string, { title, page, recipe, graphs, layout }: RecipeProject): Recipe | null {
  const graph = getOwn(migrateNodes({ graphs }, library).project.graphs, RECIPE_GRAPH);
  const ports = graph && createInterfaceLookup({ graphs: { [RECIPE_GRAPH]: graph } }, library)(subgraphType(RECIPE_GRAPH));
  if (!graph || !ports || Object.values(graph.nodes).some((node) => library.definition(node.type) === undefined)) return null;
  const { inputs, outputs, params } = ports;
  const places = placeNodes(graph, getOwn(layout, RECIPE_GRAPH));
  const nodes = inOrder(Object.entries(graph.nodes).map(([id, node]) => [id, { ...node, x: 0, y: 0, ...places[id] }]));
  return {
    definition: defineNode({
      type,
      version: 1,
      title,
      doc: page.description,
      keywords: recipe?.keywords ?? [],
      inputs,
      outputs,
      params,
      lowering: { kind: 'behavior' },
    }),
    nodes: Object.fromEntries(nodes),
    wires: graph.wires,
    ports: Object.fromEntries([...graph.exposed.inputs, ...graph.exposed.outputs].map(({ name, node, port }) => [name, `${node}.${port}`])),
    main: nodes[0]?.[0] ?? '',
    ...factsOf(graph, library),
  };
}

type RecipeProject = Pick<Project, 'title' | 'graphs' | 'layout' | 'recipe'> & { readonly page: Pick<Project['page'], 'description'> };

type PlacedNode = readonly [id: string, node: GraphNode & NodeLayout];

/** The main node first, which keeps its place; then from right to left, so that the nodes before it make way. */
function inOrder(nodes: readonly PlacedNode[]): readonly PlacedNode[] {
  const distance = ([, { x, y }]: PlacedNode) => Math.hypot(x, y);
  const main = nodes.reduce<PlacedNode | null>((best, node) => (best !== null && distance(best) <= distance(node) ? best : node), null);
  const others = nodes.filter((node) => node !== main).sort(([, a], [, b]) => b.x - a.x || a.y - b.y);
  return main === null ? [] : [main, ...others];
}

function appliedTechnique(library: NodeLibrary, { type, version, title, doc, keywords = [] }: NodeDefinition): Recipe | null {
  const graph: Graph = {
    nodes: {
      apply: { type: 'objects/apply-technique', version: library.definition('objects/apply-technique')?.version ?? 1, params: {} },
      technique: { type, version, params: {} },
    },
    wires: [{ from: { node: 'technique', port: 'technique' }, to: { node: 'apply', port: 'technique' } }],
    exposed: {
      inputs: [{ name: 'objects', node: 'apply', port: 'objects' }],
      outputs: [{ name: 'objects', node: 'apply', port: 'objects' }],
    },
  };
  const layout: GraphLayout = { ...EMPTY_LAYOUT, nodes: { apply: { x: 0, y: 0 }, technique: { x: -COLUMN_PX, y: ROW_PX } } };
  return toRecipe(library, `${CATEGORY}on-objects-${type.replaceAll('/', '-')}`, {
    title: `${title} on objects`,
    page: { description: `${doc} Adds a Set material node, too, which applies it to objects.` },
    recipe: { keywords },
    graphs: { [RECIPE_GRAPH]: graph },
    layout: { [RECIPE_GRAPH]: layout },
  });
}
