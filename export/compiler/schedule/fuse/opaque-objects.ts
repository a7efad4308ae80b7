import { type FlatGraph, type FlatNode, type Source, sourcesAt } from '../../flat-graph.ts';
import type { ScheduledDraw } from '../scheduled.ts';
import { movingBinding, startValue } from '../slot-allocator.ts';
import type { SeparateReason } from './separate-wire.ts';

/** The node type that draws objects with their own materials. */
const SCENE = 'layer/scene';

/** Node types that hand objects on with the materials that they have. A test compares them with the runtimes. */
export const KEEPING_MATERIALS: readonly string[] = [
  'objects/at-pose',
  'objects/copies',
  'objects/group',
  'objects/transform',
  'physics/body',
];

/** Node types whose objects have one material, which is transparent only if the alpha of their param `color` is below 1. */
export const COLORED: readonly string[] = ['objects/primitive', 'objects/text-3d'];

/** Light nodes that may show a panorama behind the objects, by their param `visible`. Others draw nothing. */
const MAY_SHOW_PANORAMA: readonly string[] = ['light/environment', 'light/from-panorama'];
const SHOWING_NOTHING: readonly string[] = ['light/directional', 'light/point', 'light/spot', 'world/light-estimate'];

/**
 * Why effects cannot be computed in the materials of a draw: it has none, or its surfaces may blend. Null if each pixel that the draw colors
 * shows one opaque surface.
 *
 * @param opaqueModels Ids of model assets without transparent materials.
 */
export function whyNotOpaque(graph: FlatGraph, draw: ScheduledDraw, opaqueModels: ReadonlySet<string>): SeparateReason | null {
  const scene = graph.nodes.get(draw.node);
  if (scene?.definition.type !== SCENE || draw.glass) return 'objects';
  const occlusion = draw.occlusion === null ? null : graph.nodes.get(draw.occlusion.node);
  const isHard = !occlusion || (isZero(occlusion, 'softnessM') && isZero(occlusion, 'borderPx'));
  const isClear = isHard && nodesAt(graph, sourcesAt(scene, 'lights')).every(showsNothing);
  return isClear && drawsOpaque(graph, scene, opaqueModels) ? null : 'transparent';
}

/** Whether a light node only lights objects. */
function showsNothing(light: FlatNode): boolean {
  const { type } = light.definition;
  return SHOWING_NOTHING.includes(type) || (MAY_SHOW_PANORAMA.includes(type) && fixedValue(light, 'visible') === false);
}

/** Whether all objects that a scene draws are opaque. */
function drawsOpaque(graph: FlatGraph, scene: FlatNode, opaqueModels: ReadonlySet<string>): boolean {
  const behind = new Set(nodesAt(graph, sourcesAt(scene, 'objects')));
  // The set grows during the iteration.
  for (const node of behind) {
    if (KEEPING_MATERIALS.includes(node.definition.type))
      for (const before of nodesAt(graph, sourcesAt(node, 'objects'))) behind.add(before);
    else if (!makesOpaque(node, opaqueModels)) return false;
  }
  return true;
}

/** Whether the objects that a node makes are opaque, or phantoms, of which only depth is drawn. */
function makesOpaque(node: FlatNode, opaqueModels: ReadonlySet<string>): boolean {
  const { type } = node.definition;
  if (type === 'objects/phantom') return true;
  if (type === 'source/model') return opaqueModels.has(String(fixedValue(node, 'model')));
  const color = COLORED.includes(type) ? fixedValue(node, 'color') : null;
  return Array.isArray(color) && color[3] === 1;
}

function isZero(node: FlatNode, param: string): boolean {
  return fixedValue(node, param) === 0;
}

/** The value of a param that no wire, expression or track changes; null if one does. */
function fixedValue(node: FlatNode, name: string): unknown {
  const param = node.definition.params[name];
  return param === undefined || node.inputs.has(name) || movingBinding(node, name) !== null ? null : startValue(node, name, param);
}

function nodesAt(graph: FlatGraph, sources: readonly Source[]): FlatNode[] {
  return sources.flatMap(({ node }) => graph.nodes.get(node) ?? []);
}
