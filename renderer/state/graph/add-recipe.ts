import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import type { PortAddress, Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Place } from '../editor/canvas-state.ts';
import { addCopy } from './add-copy.ts';
import { type Recipe, ROW_PX } from './recipes.ts';
import { COLUMN_PX } from './show-layer.ts';

export interface AddedRecipe {
  /** The main node of the recipe. */
  readonly main: string;
  readonly ids: readonly string[];
  /** The port of an added node, by port of the recipe. */
  readonly portOf: (port: string) => PortAddress | null;
  readonly change: (project: Project) => Change;
  /** Connects the lights of the graph, or a new one, to the inputs for lights that have none. Comes after the wires of the person. */
  readonly light: (project: Project) => Change;
}

interface AddRecipe extends Place {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly random: () => number;
  readonly project: Project;
}

export function addRecipe(recipe: Recipe, context: AddRecipe): AddedRecipe {
  const { library, graph, random, project, x, y } = context;
  const ids = new Map(Object.entries(recipe.nodes).map(([name, { type }]) => [name, makeNodeId(project, type, random)]));
  const idOf = (name: string) => ids.get(name) ?? name;
  const place = ({ node, port }: PortAddress): PortAddress => ({ node: idOf(node), port });
  const portOf = (name: string): PortAddress | null => {
    const [node, port] = getOwn(recipe.ports, name)?.split('.') ?? [];
    return node === undefined || port === undefined ? null : place({ node, port });
  };
  const origin = recipe.nodes[recipe.main] ?? { x: 0, y: 0 };
  const adds = Object.entries(recipe.nodes).map(
    ([name, node]) =>
      (before: Project): Change =>
        addCopy(before, {
          library,
          graph,
          id: idOf(name),
          node: { ...node, x: x + node.x - origin.x, y: y + node.y - origin.y },
        }),
  );
  const wires = recipe.wires.map(
    ({ from, to }) =>
      (before: Project): Change =>
        connect(before, { library, graph, from: place(from), to: place(to) }),
  );
  const lit = recipe.lit.flatMap((name) => portOf(name) ?? []);
  return {
    main: idOf(recipe.main),
    ids: [...ids.values()],
    portOf,
    change: (before) => sequence(before, ...adds, ...wires),
    light: (before) => sequence(before, ...lit.map((to) => (p: Project) => bringLight(p, to, context))),
  };
}

/** All outputs with lights in a graph. */
export function lightsOf(project: Project, library: NodeLibrary, graph: string): PortAddress[] {
  return Object.entries(project.graphs[graph]?.nodes ?? {}).flatMap(([node, { type }]) =>
    Object.entries(library.definition(type)?.outputs ?? {}).flatMap(([port, output]) => (output.type === 'lights' ? [{ node, port }] : [])),
  );
}

function bringLight(project: Project, to: PortAddress, { library, graph, random, x, y }: AddRecipe): Change {
  const { wires = [] } = project.graphs[graph] ?? {};
  if (wires.some((wire) => wire.to.node === to.node && wire.to.port === to.port)) return unchanged(project);
  const lights = lightsOf(project, library, graph);
  const type = 'light/directional';
  const id = makeNodeId(project, type, random);
  const from = lights.length > 0 ? lights : [{ node: id, port: 'lights' }];
  return sequence(
    project,
    (before) =>
      lights.length > 0 ? unchanged(before) : addNode(before, { library, graph, id, type, x: x - COLUMN_PX, y: y + 2 * ROW_PX }),
    ...from.map((light) => (before: Project) => connect(before, { library, graph, from: light, to })),
  );
}
