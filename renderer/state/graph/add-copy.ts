import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { setCollapsed } from '../../../export/graph/commands/layout-commands.ts';
import { addNode, setMuted, setUnfused } from '../../../export/graph/commands/node-commands.ts';
import { bindParam } from '../../../export/graph/commands/param-commands.ts';
import type { GraphNode, NodeLayout, Project } from '../../../export/graph/project.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';

export interface AddCopy {
  readonly library: NodeLibrary;
  readonly graph: string;
  /** From `makeNodeId`. */
  readonly id: string;
  readonly node: GraphNode & NodeLayout;
}

/** Adds a node with all that a copied one has: its bindings, whether it is muted, fused and collapsed. */
export function addCopy(project: Project, { library, graph, id, node }: AddCopy): Change {
  const { type, x, y, params, muted, unfused, collapsed } = node;
  return sequence(
    project,
    (p) => addNode(p, { library, graph, id, type, x, y }),
    ...Object.entries(params).map(
      ([param, binding]) =>
        (p: Project) =>
          bindParam(p, { library, graph, node: id, param, binding }),
    ),
    (p) => (muted ? setMuted(p, { graph, nodes: [id], muted: true }) : unchanged(p)),
    (p) => (unfused ? setUnfused(p, { graph, nodes: [id], unfused: true }) : unchanged(p)),
    (p) => (collapsed ? setCollapsed(p, { graph, nodes: [id], collapsed: true }) : unchanged(p)),
  );
}
