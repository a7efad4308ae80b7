import type { ModelBounds } from '../../../export/gltf/model-bounds.ts';
import { putAsset } from '../../../export/graph/commands/asset-commands.ts';
import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import type { Asset, Project } from '../../../export/graph/project.ts';
import type { AssetKind, NodeLibrary } from '../../../nodes/kit/definition.ts';
import { POSITION_PARAM } from '../../../nodes/kit/pose-params.ts';
import { type AddStep, apply } from '../document/apply.ts';
import type { Place } from '../editor/canvas-state.ts';
import { graphOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { fileTitle } from '../editor/node-title.ts';
import { revealNodes } from '../editor/ui.ts';
import { type FloorPoint, floorInView } from './floor-point.ts';
import { placeFreely } from './free-places.ts';
import { showLayer } from './show-layer.ts';
import { showObjects } from './show-objects.ts';
import { type Standing, standOnFloor } from './stand-on-floor.ts';

/** Type of the data that a drag of an asset carries: the id of the asset. */
export const ASSET_DRAG = 'application/x-scrim-asset';

interface PlacedAsset {
  readonly id: string;
  readonly asset: Asset;
  /** For a capture that is shown at once: where an eye sees it. */
  readonly start?: CaptureStart | null;
  /** For a model: its size, and the point of the floor where it stands. */
  readonly bounds?: ModelBounds | null;
  readonly floor?: FloorPoint | undefined;
  readonly step?: AddStep;
}

/** A camera of a capture. */
interface CaptureStart {
  readonly positionM: readonly number[];
  /** The angle about y of where it looks. */
  readonly yawRad: number;
}

/** Where an eye is before the first frame: at the height of a visitor. Column-major 4×4. */
const USUAL_EYE = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1.6, 0, 1];
/** The range of the position of a node. */
const MOST_M: number = POSITION_PARAM.max[0];

/**
 * Params that put a capture so that this camera of it is where the eye is, and looks to the same side.
 *
 * @param eye Column-major pose of the eye.
 */
function poseAround({ positionM: [x = 0, y = 0, z = 0], yawRad }: CaptureStart, eye: readonly number[]) {
  const turn = Math.atan2(eye[8] ?? 0, eye[10] ?? 1) - yawRad;
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  const rounded = (value: number): number => Number(value.toFixed(4));
  const turned = [cos * x + sin * z, y, cos * z - sin * x];
  return {
    positionM: turned.map((value, axis) => rounded(Math.min(MOST_M, Math.max(-MOST_M, (eye[12 + axis] ?? 0) - value)))),
    rotationRad: [0, rounded(Math.atan2(sin, cos)), 0],
  };
}

/**
 * Adds a node that outputs an asset, and the asset unless the project has it, as one undo step. A model is also put into the scene, and a
 * captured place or splats over the layer on the screen, so that they are visible at once. Returns the node to select; null if no node
 * outputs such assets.
 */
export function placeAsset(
  editor: Editor,
  { id: assetId, asset, start, bounds = null, floor, step = {} }: PlacedAsset,
  place: Place,
): string | null {
  const { project, library, graph } = editor.document.getState();
  const source = sourceOf(library, asset.kind);
  const { key, label = `Add ${fileTitle(asset.path)}` } = step;
  if (source === null) {
    apply(editor, label, putAsset(project, { id: assetId, asset }), key);
    return null;
  }
  const id = makeNodeId(project, source.type, editor.random);
  const change = sequence(
    project,
    (before) => putAsset(before, { id: assetId, asset }),
    (before) =>
      addNode(before, {
        library,
        graph,
        id,
        type: source.type,
        ...place,
        params: { [source.param]: assetId, ...(start && poseAround(start, editor.preview.getState().status?.worldFromView ?? USUAL_EYE)) },
      }),
    shown(editor, asset.kind, id, place, standOnFloor(floor ?? floorInView(editor.preview.getState().status), bounds)),
    placeFreely(project, { library, graph, hasThumbnail: editor.preferences.getState().thumbnails }),
  );
  if (!apply(editor, label, change, key)) return null;
  return selectPlacement(editor, id, project);
}

/** Makes a new node visible, if it is a thing to be placed or a place. Images and videos are materials for other nodes. */
function shown({ document, random }: Editor, kind: AssetKind, id: string, place: Place, standing: Standing): (project: Project) => Change {
  const { library } = document.getState();
  if (kind === 'model') return showObjects({ node: id, port: 'objects' }, place, { library, random }, standing);
  return kind === 'capture' || kind === 'splats' ? showLayer({ node: id, port: 'layer' }, place, { library, random }) : unchanged;
}

/**
 * Scrolls to the nodes that were added to show an asset. Returns the Transform that places it, or its node if no Transform was added.
 */
function selectPlacement(editor: Editor, source: string, before: Project): string {
  const state = editor.document.getState();
  const { nodes } = graphOf(state);
  const added = Object.keys(nodes).filter((id) => before.graphs[state.graph]?.nodes[id] === undefined);
  const outputs = Object.keys(nodes).filter((id) => nodes[id]?.type === 'output/screen');
  if (added.length > 1) revealNodes(editor.ui, [...added, ...outputs], 'fit');
  return added.find((id) => nodes[id]?.type === 'objects/transform') ?? source;
}

/** The source node with an asset param of this kind; of several, the plain one: `source/capture`, not `source/capture-mesh`. */
function sourceOf(library: NodeLibrary, kind: AssetKind): { readonly type: string; readonly param: string } | null {
  for (const type of [...library.types()].sort()) {
    const definition = library.definition(type);
    if (!definition || !type.startsWith('source/')) continue;
    const param = Object.entries(definition.params).find(([, candidate]) => candidate.type === 'asset' && candidate.accept === kind);
    if (param) return { type, param: param[0] };
  }
  return null;
}
