import { convertLayers } from '../../export/graph/commands/convert-layers.ts';
import { addNode } from '../../export/graph/commands/node-commands.ts';
import { connect } from '../../export/graph/commands/wire-commands.ts';
import { EMPTY_LAYOUT, newProject } from '../../export/graph/new-project.ts';
import { placeNodes } from '../../export/graph/place-nodes.ts';
import { MAIN_GRAPH, type PortAddress, type Project } from '../../export/graph/project.ts';
import { type NodeDefinition, type NodeLibrary, paramWireType } from '../../nodes/kit/definition.ts';
import { hasErrors } from '../../nodes/kit/diagnostics.ts';
import { conversion, type WireType } from '../../nodes/kit/wire-types.ts';

/**
 * The smallest project that shows a node: suppliers for its required inputs, and the shortest chain of nodes from its outputs to the
 * Output node. The result depends only on the library. If there is no such chain, the node is alone.
 *
 * @param type A type of the library.
 * @throws If the library does not have the type.
 */
export function surround(library: NodeLibrary, type: string, title: string): Project {
  const definitions = [...library.types()].sort().flatMap((name) => library.definition(name) ?? []);
  const own = definitions.find((definition) => definition.type === type);
  if (!own) throw new Error(`The node type ${type} does not exist.`);
  const builder = createBuilder(library, title);
  const suppliers = cheapestSuppliers(definitions);
  /** The nodes that supply inputs, by `node.port`. */
  const supplied = new Map<string, { readonly id: string; readonly definition: NodeDefinition }>();
  const supply = (id: string, definition: NodeDefinition, taken: string | null): void => {
    for (const [name, port] of Object.entries(definition.inputs)) {
      if (!port.required || name === taken) continue;
      const supplier = suppliers.get(port.type);
      if (!supplier) continue;
      const from = builder.place(supplier.definition);
      supplied.set(`${id}.${name}`, { id: from, definition: supplier.definition });
      supply(from, supplier.definition, null);
      builder.wire({ node: from, port: supplier.port }, { node: id, port: name });
    }
  };
  let last = builder.place(own);
  supply(last, own, null);
  // A node that acts on another is seen by what it does to that one.
  const shown = (own.actsOn !== undefined && supplied.get(`${last}.${own.actsOn}`)) || { id: last, definition: own };
  last = shown.id;
  let start = shown.definition;
  // A node that is heard needs any picture beside it.
  const layer = own.heard ? suppliers.get('layer')?.definition : undefined;
  if (layer) {
    last = builder.place(layer);
    supply(last, layer, null);
    start = layer;
  }
  for (const step of chainToOutput(start, definitions)) {
    const id = builder.place(step.definition);
    builder.wire({ node: last, port: step.fromPort }, { node: id, port: step.toPort });
    supply(id, step.definition, step.toPort);
    last = id;
  }
  return builder.finish();
}

/** Builds the project. Ids of nodes are a stem and a number: `sepia-x1`, `sepia-x2`. */
function createBuilder(library: NodeLibrary, title: string) {
  let project = newProject(title);
  const apply = (next: ReturnType<typeof addNode>): void => {
    if (hasErrors(next.diagnostics)) throw new Error(next.diagnostics.map((d) => d.message).join(' '));
    project = next.project;
  };
  return {
    place: ({ type }: NodeDefinition): string => {
      const id = freeId(project, type);
      apply(addNode(project, { library, graph: MAIN_GRAPH, id, type, x: 0, y: 0 }));
      return id;
    },
    wire: (from: PortAddress, to: PortAddress): void => apply(connect(project, { library, graph: MAIN_GRAPH, from, to })),
    finish: (): Project => {
      apply(convertLayers(project, { library, graph: MAIN_GRAPH, first: [], except: [], makeId: freeId }));
      const graph = project.graphs[MAIN_GRAPH];
      if (!graph) throw new Error('A project has a main graph.');
      return { ...project, layout: { [MAIN_GRAPH]: { ...EMPTY_LAYOUT, nodes: placeNodes(graph, undefined) } } };
    },
  };
}

function freeId(project: Project, type: string): string {
  const stem = type.slice(type.indexOf('/') + 1);
  const taken = project.graphs[MAIN_GRAPH]?.nodes ?? {};
  let number = 1;
  while (Object.hasOwn(taken, `${stem}-x${number}`)) number++;
  return `${stem}-x${number}`;
}

interface Supplier {
  readonly definition: NodeDefinition;
  readonly port: string;
  /** The sum of `priceOf` over the node and the suppliers of its required inputs. */
  readonly nodes: number;
}

/** The cost of one node: higher if it requests device features, highest if it shows nothing until a file is chosen. */
function priceOf({ needs, params }: NodeDefinition): number {
  if (Object.values(params).some(({ stage }) => stage === 'asset')) return 3;
  return needs?.length ? 1.5 : 1;
}

/** For each wire type the output with the lowest cost; of equal ones the first by name. */
function cheapestSuppliers(definitions: readonly NodeDefinition[]): ReadonlyMap<WireType, Supplier> {
  const suppliers = new Map<WireType, Supplier>();
  const cost = (definition: NodeDefinition): number =>
    Object.values(definition.inputs)
      .filter((port) => port.required)
      .reduce((sum, port) => sum + (suppliers.get(port.type)?.nodes ?? Number.POSITIVE_INFINITY), priceOf(definition));
  // The cost of a supplier can drop when suppliers of its inputs are found; each iteration settles at least one type.
  for (let changed = true; changed; ) {
    changed = false;
    for (const definition of definitions) {
      const nodes = cost(definition);
      for (const [port, { type }] of Object.entries(definition.outputs)) {
        if (nodes >= (suppliers.get(type)?.nodes ?? Number.POSITIVE_INFINITY)) continue;
        suppliers.set(type, { definition, port, nodes });
        changed = true;
      }
    }
  }
  return suppliers;
}

interface Step {
  readonly fromPort: string;
  readonly definition: NodeDefinition;
  readonly toPort: string;
}

/** The shortest chain of nodes that ends at an Output node; empty for an Output node, and if there is no chain. */
function chainToOutput(start: NodeDefinition, definitions: readonly NodeDefinition[]): readonly Step[] {
  const seen = new Set([start.type]);
  const queue: { readonly definition: NodeDefinition; readonly steps: readonly Step[] }[] = [{ definition: start, steps: [] }];
  for (const { definition, steps } of queue) {
    if (definition.lowering.kind === 'present') return steps;
    for (const next of definitions) {
      const link = seen.has(next.type) ? null : linkBetween(definition, next);
      if (!link) continue;
      seen.add(next.type);
      queue.push({ definition: next, steps: [...steps, { ...link, definition: next }] });
    }
  }
  return [];
}

function linkBetween(from: NodeDefinition, to: NodeDefinition): Pick<Step, 'fromPort' | 'toPort'> | null {
  const params = Object.entries(to.params).map(([name, param]) => [name, paramWireType(param)] as const);
  const targets = [...Object.entries(to.inputs).map(([name, port]) => [name, port.type] as const), ...params];
  for (const [fromPort, output] of Object.entries(from.outputs)) {
    const target = targets.find(([, type]) => type !== undefined && conversion(output.type, type) !== 'none');
    if (target) return { fromPort, toPort: target[0] };
  }
  return null;
}
