import { addNode } from '../../export/graph/commands/node-commands.ts';
import { connect } from '../../export/graph/commands/wire-commands.ts';
import { EMPTY_LAYOUT, newProject } from '../../export/graph/new-project.ts';
import { placeNodes } from '../../export/graph/place-nodes.ts';
import { MAIN_GRAPH, type PortAddress, type Project } from '../../export/graph/project.ts';
import { type NodeDefinition, type NodeLibrary, paramWireType } from '../../nodes/kit/definition.ts';
import { hasErrors } from '../../nodes/kit/diagnostics.ts';
import { conversion, type WireType } from '../../nodes/kit/wire-types.ts';

/**
 * The smallest project that shows a node: what its required ports ask for, and a way from its outputs to the screen, made of
 * whatever the library offers. The same library gives the same project. Where there is no way, the node stands alone.
 */
export function surround(library: NodeLibrary, type: string, title: string): Project {
  const definitions = [...library.types()].sort().flatMap((name) => library.definition(name) ?? []);
  const own = definitions.find((definition) => definition.type === type);
  if (!own) throw new Error(`There is no node type ${type}.`);
  const builder = createBuilder(library, title);
  const suppliers = cheapestSuppliers(definitions);
  const supply = (id: string, definition: NodeDefinition, taken: string | null): void => {
    for (const [name, port] of Object.entries(definition.inputs)) {
      if (!port.required || name === taken) continue;
      const supplier = suppliers.get(port.type);
      if (!supplier) continue;
      const from = builder.place(supplier.definition);
      supply(from, supplier.definition, null);
      builder.wire({ node: from, port: supplier.port }, { node: id, port: name });
    }
  };
  let last = builder.place(own);
  supply(last, own, null);
  for (const step of wayToScreen(own, definitions)) {
    const id = builder.place(step.definition);
    builder.wire({ node: last, port: step.fromPort }, { node: id, port: step.toPort });
    supply(id, step.definition, step.toPort);
    last = id;
  }
  return builder.finish();
}

/** Ids count up within a stem: `sepia-x1`, `sepia-x2`. */
function createBuilder(library: NodeLibrary, title: string) {
  let project = newProject(title);
  const apply = (next: ReturnType<typeof addNode>): void => {
    if (hasErrors(next.diagnostics)) throw new Error(next.diagnostics.map((d) => d.message).join(' '));
    project = next.project;
  };
  return {
    place: ({ type }: NodeDefinition): string => {
      const stem = type.slice(type.indexOf('/') + 1);
      const taken = project.graphs[MAIN_GRAPH]?.nodes ?? {};
      let number = 1;
      while (Object.hasOwn(taken, `${stem}-x${number}`)) number++;
      const id = `${stem}-x${number}`;
      apply(addNode(project, { library, graph: MAIN_GRAPH, id, type, x: 0, y: 0 }));
      return id;
    },
    wire: (from: PortAddress, to: PortAddress): void => apply(connect(project, { library, graph: MAIN_GRAPH, from, to })),
    finish: (): Project => {
      const graph = project.graphs[MAIN_GRAPH];
      if (!graph) throw new Error('A project has a main graph.');
      return { ...project, layout: { [MAIN_GRAPH]: { ...EMPTY_LAYOUT, nodes: placeNodes(graph, undefined) } } };
    },
  };
}

interface Supplier {
  readonly definition: NodeDefinition;
  readonly port: string;
  /** Nodes it takes, those it needs itself included, and what `priceOf` adds. */
  readonly nodes: number;
}

/** A node alone; dearer with needs, and dearest where it shows nothing before somebody has chosen a file. */
function priceOf({ needs, params }: NodeDefinition): number {
  if (Object.values(params).some(({ stage }) => stage === 'asset')) return 3;
  return needs?.length ? 1.5 : 1;
}

/** Per wire type the output that takes the fewest nodes; of equals, the cheapest, then the first by name. */
function cheapestSuppliers(definitions: readonly NodeDefinition[]): ReadonlyMap<WireType, Supplier> {
  const suppliers = new Map<WireType, Supplier>();
  const cost = (definition: NodeDefinition): number =>
    Object.values(definition.inputs)
      .filter((port) => port.required)
      .reduce((sum, port) => sum + (suppliers.get(port.type)?.nodes ?? Number.POSITIVE_INFINITY), priceOf(definition));
  // A supplier may become cheaper once those of its own inputs are known; each round settles at least one type.
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

/** The shortest chain of nodes that ends at a screen; empty for a screen itself and where there is none. */
function wayToScreen(start: NodeDefinition, definitions: readonly NodeDefinition[]): readonly Step[] {
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
