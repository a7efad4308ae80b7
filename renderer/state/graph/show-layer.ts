import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { moveNodes } from '../../../export/graph/commands/layout-commands.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect, disconnect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import { MAIN_GRAPH, type PortAddress, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Place } from '../editor/canvas-state.ts';

export const COLUMN_PX = 240;

export interface ShowContext {
  readonly library: NodeLibrary;
  readonly random: () => number;
}

/** The output of the main graph; null without one, and with several, where only the user can choose. */
export function soleScreen({ graphs }: Project): string | null {
  const { nodes = {} } = graphs[MAIN_GRAPH] ?? {};
  const [screen, ...others] = Object.keys(nodes).filter((id) => nodes[id]?.type === 'output/screen');
  return screen === undefined || others.length > 0 ? null : screen;
}

/**
 * Makes the layer of a new node visible: over what is on the screen, or alone on a screen without input. Changes nothing in subgraphs, and in
 * graphs without a single output.
 *
 * @param place Position of its node in canvas units.
 */
export function showLayer(layer: PortAddress, place: Place, { library, random }: ShowContext): (project: Project) => Change {
  return (project) => {
    const graph = MAIN_GRAPH;
    const { nodes = {}, wires = [] } = project.graphs[graph] ?? {};
    const screen = soleScreen(project);
    if (screen === null || !nodes[layer.node]) return unchanged(project);
    const wire = (from: PortAddress, node: string, port: string) => (before: Project) =>
      connect(before, { library, graph, from, to: { node, port } });
    const shown = wires.find(({ to }) => to.node === screen && to.port === 'layer');
    if (shown === undefined) return wire(layer, screen, 'layer')(project);
    const { x, y } = getOwn(project.layout[graph]?.nodes ?? {}, screen) ?? place;
    const column = Math.max(x, place.x + COLUMN_PX);
    const over = makeNodeId(project, 'operator/over', random);
    return sequence(
      project,
      (before) => addNode(before, { library, graph, id: over, type: 'operator/over', x: column, y, params: {} }),
      (before) => disconnect(before, { graph, wires: [shown] }),
      wire(shown.from, over, 'bottom'),
      wire(layer, over, 'top'),
      wire({ node: over, port: 'layer' }, screen, 'layer'),
      (before) => moveNodes(before, { graph, positions: { [screen]: { x: column + COLUMN_PX, y } } }),
    );
  };
}
