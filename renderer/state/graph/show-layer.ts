import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { moveNodes } from '../../../export/graph/commands/layout-commands.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect, disconnect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import { MAIN_GRAPH, type PortAddress, type Project, type Wire } from '../../../export/graph/project.ts';
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

/**
 * Makes a layer of shadows visible: above the background, below the objects. It goes over the lowest layer that the output shows, or below it
 * if that is a scene. Changes nothing in graphs without a single output.
 *
 * @param place Position of its node in canvas units.
 */
export function showShadows(layer: PortAddress, place: Place, context: ShowContext): (project: Project) => Change {
  return (project) => {
    const graph = MAIN_GRAPH;
    const { library, random } = context;
    const { nodes = {}, wires = [] } = project.graphs[graph] ?? {};
    const screen = soleScreen(project);
    let lowest = wires.find(({ to }) => to.node === screen && to.port === 'layer');
    if (lowest === undefined || !nodes[layer.node]) return showLayer(layer, place, context)(project);
    let wire: Wire | undefined = lowest;
    let source = lowest.from.node;
    // Down through composites to their lower layer, and through filters to their only one.
    for (let count = wires.length; wire !== undefined && count > 0; count--) {
      source = wire.from.node;
      const inputs: readonly Wire[] = wires.filter(({ to, from }) => to.node === source && isLayer(project, library, from));
      const bottom: Wire | undefined = inputs.find(({ to }) => to.port === 'bottom');
      lowest = bottom ?? lowest;
      wire = bottom ?? (inputs.length === 1 ? inputs[0] : undefined);
    }
    const { from, to } = lowest;
    const [top, bottom] = nodes[source]?.type === 'layer/scene' ? [from, layer] : [layer, from];
    const over = makeNodeId(project, 'operator/over', random);
    const connectTo = (source: PortAddress, target: PortAddress) => (before: Project) =>
      connect(before, { library, graph, from: source, to: target });
    return sequence(
      project,
      (before) => addNode(before, { library, graph, id: over, type: 'operator/over', x: place.x + COLUMN_PX, y: place.y, params: {} }),
      (before) => disconnect(before, { graph, wires: [{ from, to }] }),
      connectTo(bottom, { node: over, port: 'bottom' }),
      connectTo(top, { node: over, port: 'top' }),
      connectTo({ node: over, port: 'layer' }, to),
    );
  };
}

function isLayer({ graphs }: Project, library: NodeLibrary, { node, port }: PortAddress): boolean {
  const type = graphs[MAIN_GRAPH]?.nodes[node]?.type ?? '';
  return getOwn(library.definition(type)?.outputs ?? {}, port)?.type === 'layer';
}
