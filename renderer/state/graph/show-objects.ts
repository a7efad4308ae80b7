import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { moveNodes } from '../../../export/graph/commands/layout-commands.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect, disconnect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import { MAIN_GRAPH, type PortAddress, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Place } from '../editor/canvas-state.ts';

const COLUMN_PX = 240;
const ROW_PX = 112;
/** Position of new objects: on the floor, in view of the recorded studio and of a visitor at the origin. */
const POSITION_M = [0, 0, -1.5];

interface ShowContext {
  readonly library: NodeLibrary;
  readonly random: () => number;
}

/**
 * Makes the objects of a new node visible: they stand on the floor in front of the visitor, in the scene of the graph. Without a scene, adds
 * one with a light and draws it over the layer on the screen. Changes nothing in subgraphs, in graphs without an output, and in graphs
 * with several scenes, where only the user can choose.
 *
 * @param from Output with the objects.
 * @param place Position of its node in canvas units.
 */
export function showObjects(from: PortAddress, place: Place, { library, random }: ShowContext): (project: Project) => Change {
  return (project) => {
    const graph = MAIN_GRAPH;
    const { nodes = {} } = project.graphs[graph] ?? {};
    const idsOf = (type: string): string[] => Object.keys(nodes).filter((id) => nodes[id]?.type === type);
    const [screen, ...otherScreens] = idsOf('output/screen');
    const scenes = idsOf('layer/scene');
    if (!nodes[from.node] || screen === undefined || otherScreens.length > 0 || scenes.length > 1) return unchanged(project);

    const steps: ((before: Project) => Change)[] = [];
    const add = (type: string, x: number, y: number, params = {}): string => {
      const id = makeNodeId(project, type, random);
      steps.push((before) => addNode(before, { library, graph, id, type, x, y, params }));
      return id;
    };
    const wire = (source: PortAddress, node: string, port: string): void => {
      steps.push((before) => connect(before, { library, graph, from: source, to: { node, port } }));
    };

    const transform = add('objects/transform', place.x + COLUMN_PX, place.y, { positionM: POSITION_M });
    wire(from, transform, 'objects');
    const objects = { node: transform, port: 'objects' };
    const [scene] = scenes;
    if (scene !== undefined) {
      wire(objects, scene, 'objects');
      const [shadow, ...otherShadows] = idsOf('layer/shadow');
      if (shadow !== undefined && otherShadows.length === 0) wire(objects, shadow, 'casters');
      return sequence(project, ...steps);
    }

    const added = add('layer/scene', place.x + 2 * COLUMN_PX, place.y);
    wire(objects, added, 'objects');
    const light = add('light/directional', place.x + COLUMN_PX, place.y + ROW_PX);
    wire({ node: light, port: 'lights' }, added, 'lights');
    const layer = { node: added, port: 'layer' };
    return sequence(project, ...steps, showLayer(layer, { x: place.x + 2 * COLUMN_PX, y: place.y }, { library, random }));
  };
}

/**
 * Draws the layer of a new node over the layer on the screen. Changes nothing in subgraphs and in graphs without an output.
 *
 * @param from Output with the layer.
 * @param place Position of its node in canvas units.
 */
export function showLayer(from: PortAddress, place: Place, { library, random }: ShowContext): (project: Project) => Change {
  return (project) => {
    const graph = MAIN_GRAPH;
    const { nodes = {}, wires = [] } = project.graphs[graph] ?? {};
    const [screen, ...otherScreens] = Object.keys(nodes).filter((id) => nodes[id]?.type === 'output/screen');
    if (!nodes[from.node] || screen === undefined || otherScreens.length > 0) return unchanged(project);
    const wire = (source: PortAddress, node: string, port: string) => (before: Project) =>
      connect(before, { library, graph, from: source, to: { node, port } });
    const shown = wires.find(({ to }) => to.node === screen && to.port === 'layer');
    if (shown === undefined) return sequence(project, wire(from, screen, 'layer'));
    const { x, y } = getOwn(project.layout[graph]?.nodes ?? {}, screen) ?? place;
    const over = makeNodeId(project, 'operator/over', random);
    const overX = Math.max(x, place.x + COLUMN_PX);
    return sequence(
      project,
      (before) => addNode(before, { library, graph, id: over, type: 'operator/over', x: overX, y, params: {} }),
      (before) => disconnect(before, { graph, wires: [shown] }),
      wire(shown.from, over, 'bottom'),
      wire(from, over, 'top'),
      wire({ node: over, port: 'layer' }, screen, 'layer'),
      (before) => moveNodes(before, { graph, positions: { [screen]: { x: overX + COLUMN_PX, y } } }),
    );
  };
}
