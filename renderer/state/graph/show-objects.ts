import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import { MAIN_GRAPH, type PortAddress, type Project } from '../../../export/graph/project.ts';
import type { Place } from '../editor/canvas-state.ts';
import { lightsOf } from './add-recipe.ts';
import { COLUMN_PX, type ShowContext, showLayer, soleScreen } from './show-layer.ts';
import type { Standing } from './stand-on-floor.ts';

const ROW_PX = 112;
/** On the floor, in view of the recorded studio and of a visitor at the origin. */
const BEFORE_VISITOR: Standing = { positionM: [0, 0, -1.5], scale: 1 };

/**
 * Makes the objects of a new node visible: they stand on the floor, in the scene of the graph. Without a scene, adds one with the lights of
 * the graph, or a new one, and draws it over the layer on the screen. Changes nothing in subgraphs, in graphs without an output, and in graphs
 * with several scenes, where only the user can choose.
 *
 * @param from Output with the objects.
 * @param place Position of its node in canvas units.
 * @param standing Where they stand; null if they already have their place and need no Transform. Default: in front of the visitor.
 */
export function showObjects(
  from: PortAddress,
  place: Place,
  { library, random }: ShowContext,
  standing: Standing | null = BEFORE_VISITOR,
): (project: Project) => Change {
  return (project) => {
    const graph = MAIN_GRAPH;
    const { nodes = {} } = project.graphs[graph] ?? {};
    const idsOf = (type: string): string[] => Object.keys(nodes).filter((id) => nodes[id]?.type === type);
    const scenes = idsOf('layer/scene');
    if (!nodes[from.node] || soleScreen(project) === null || scenes.length > 1) return unchanged(project);

    const steps: ((before: Project) => Change)[] = [];
    const add = (type: string, x: number, y: number, params = {}): string => {
      const id = makeNodeId(project, type, random);
      steps.push((before) => addNode(before, { library, graph, id, type, x, y, params }));
      return id;
    };
    const wire = (source: PortAddress, node: string, port: string): void => {
      steps.push((before) => connect(before, { library, graph, from: source, to: { node, port } }));
    };

    let objects = from;
    if (standing !== null) {
      const { positionM, scale } = standing;
      const params = { positionM, ...(scale !== 1 && { scale }) };
      objects = { node: add('objects/transform', place.x + COLUMN_PX, place.y, params), port: 'objects' };
      wire(from, objects.node, 'objects');
    }
    const [scene] = scenes;
    if (scene !== undefined) {
      wire(objects, scene, 'objects');
      const [shadow, ...otherShadows] = idsOf('layer/shadow');
      if (shadow !== undefined && otherShadows.length === 0)
        wire(objects, shadow, nodes[from.node]?.type === 'objects/phantom' ? 'receivers' : 'casters');
      return sequence(project, ...steps);
    }

    const added = add('layer/scene', place.x + 2 * COLUMN_PX, place.y);
    wire(objects, added, 'objects');
    const lights = lightsOf(project, library, graph);
    if (lights.length === 0) lights.push({ node: add('light/directional', place.x + COLUMN_PX, place.y + ROW_PX), port: 'lights' });
    for (const light of lights) wire(light, added, 'lights');
    steps.push(showLayer({ node: added, port: 'layer' }, { x: place.x + 2 * COLUMN_PX, y: place.y }, { library, random }));
    return sequence(project, ...steps);
  };
}
