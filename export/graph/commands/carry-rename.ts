import { castDraft } from 'immer';
import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { Graph, PortAddress, Project } from '../project.ts';
import { getOwn } from '../record.ts';
import { sortWires } from '../wires.ts';
import { type Change, carryRoutes, change, draftGraph, setWires, unchanged } from './change.ts';

export interface PortRename {
  readonly from: string;
  readonly to: string;
}

/**
 * Finds the one port or param whose name differs while its position and type are the same. Returns null if there is none, or if other ports
 * differ.
 */
export function findRename(before: NodeDefinition, after: NodeDefinition): PortRename | null {
  const old = portsOf(before);
  const now = portsOf(after);
  if (old.length !== now.length) return null;
  const changed = old.filter(({ key }, i) => key !== now[i]?.key);
  const [from] = changed;
  const to = from && now[old.indexOf(from)];
  if (changed.length !== 1 || !from || !to || from.type !== to.type) return null;
  const isNew = !old.some(({ name }) => name === to.name);
  return isNew ? { from: from.name, to: to.name } : null;
}

function portsOf({ inputs, params }: NodeDefinition) {
  const list = (kind: string, all: Readonly<Record<string, { readonly type: string }>>) =>
    Object.entries(all).map(([name, { type }]) => ({ name, type: `${kind} ${type}`, key: `${kind} ${type} ${name}` }));
  return [...list('port', inputs), ...list('param', params)];
}

/** Renames a port or param of all nodes of a type, with their wires, bindings and exposed ports. `side`: where the port is. */
export function carryRename(project: Project, type: string, { from, to }: PortRename, side: 'inputs' | 'outputs' = 'inputs'): Change {
  const users = Object.entries(project.graphs).filter(([, { nodes }]) => Object.values(nodes).some((node) => node.type === type));
  if (users.length === 0) return unchanged(project);
  const end = side === 'inputs' ? 'to' : 'from';
  return change(project, (draft) => {
    for (const [name, graph] of users) {
      const isPort = ({ node, port }: PortAddress) => port === from && getOwn(graph.nodes, node)?.type === type;
      const drafted = draftGraph(draft, name);
      for (const [id, node] of Object.entries(graph.nodes)) {
        const held = node.type === type && side === 'inputs' ? getOwn(node.params, from) : undefined;
        const target = drafted.nodes[id];
        if (held === undefined || !target) continue;
        delete target.params[from];
        target.params[to] = castDraft(held);
      }
      if (graph.wires.some((wire) => isPort(wire[end]))) {
        const renamed = graph.wires.map((wire) => (isPort(wire[end]) ? { ...wire, [end]: { ...wire[end], port: to } } : wire));
        setWires(draft, name, sortWires(renamed));
        carryRoutes(
          draft,
          name,
          graph.wires.flatMap((wire, i) => (wire === renamed[i] ? [] : [[wire, renamed[i] ?? wire]])),
        );
      }
      if (graph.exposed[side].some(isPort)) drafted.exposed = castDraft(exposedAs(graph, side, isPort, to));
    }
  });
}

/** The exposed ports after a rename of ports inside. The names under which the subgraph exposes them stay. */
function exposedAs(
  { exposed }: Graph,
  side: 'inputs' | 'outputs',
  isPort: (address: PortAddress) => boolean,
  to: string,
): Graph['exposed'] {
  return { ...exposed, [side]: exposed[side].map((shown) => (isPort(shown) ? { ...shown, port: to } : shown)) };
}
