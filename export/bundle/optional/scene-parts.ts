import type { PageUse } from '../page-entry.ts';
import { ABSENT, absent, hasPanoramas, type OptionalPart, plays } from './part.ts';

/** Whether the room depth of a program follows the edges of the camera image. */
const followsEdges = (use: PageUse): boolean =>
  plays('world/depth', { filter: 'by-sensor' })(use) || plays('world/depth', { filter: 'edge-aware' })(use);

/** Whether techniques draw edges of the objects of a page as lines. */
const drawsEdges = ({ techniqueEdges, models }: PageUse): boolean =>
  techniqueEdges === 'all' || (techniqueEdges === 'of open models' && models.open);

/** Node types that draw shadows. A test compares them with the runtimes. */
export const SHADOW_CATCHERS: readonly string[] = ['layer/negative-shadow', 'layer/shadow'];

/** Parts that draw objects, and the room that they stand in. */
export const SCENE_PARTS: readonly OptionalPart[] = [
  {
    file: 'export/runtime/resources/live-technique.ts',
    isNeeded: ({ scenes, resourceKinds, operationKinds }) => scenes && (resourceKinds.has('technique') || operationKinds.has('draw')),
    otherwise: absent('createLiveTechnique', 'layerView'),
  },
  {
    file: 'export/runtime/gl/image-store.ts',
    isNeeded: ({ scenes }) => scenes,
    otherwise: `export const createImageStore = () => ({ hold: () => ({ release() {} }), texture: () => null });`,
  },
  {
    // The models of a page were checked when it was exported.
    file: 'export/gltf/whole-model.ts',
    isNeeded: () => false,
    otherwise: `export { readPreparedModel as readWholeModel } from './prepared-model.ts';`,
  },
  {
    file: 'export/runtime/scenes/materials/effects-patch.ts',
    isNeeded: ({ materialEffects }) => materialEffects,
    otherwise: absent('createEffectsPatch'),
  },
  {
    file: 'export/runtime/scenes/materials/technique-plans.ts',
    isNeeded: ({ resourceKinds }) => resourceKinds.has('technique'),
    otherwise: `const nothing = () => {};
export const createTechniquePlans = () => ({ plan: () => null, isUsed: () => false, sweep: nothing, update: nothing, light: nothing, bind: nothing });`,
  },
  {
    file: 'export/runtime/scenes/materials/curvature/mesh-directions.ts',
    isNeeded: ({ techniqueDirections }) => techniqueDirections,
    otherwise: absent('ensureDirections'),
  },
  {
    file: 'export/runtime/scenes/materials/curvature/direction-parts.ts',
    isNeeded: ({ techniqueDirections }) => techniqueDirections,
    otherwise: `export const readsDirections = () => false;
export const DIRECTION_FRAGMENT = '';
export const DIRECTION_VARYINGS = '';
export const DIRECTION_VERTEX = { declarations: '', main: '' };`,
  },
  {
    file: 'export/runtime/scenes/materials/curvature/mesh-curvature.ts',
    isNeeded: ({ techniqueRadial }) => techniqueRadial,
    otherwise: absent('ensureCurvature'),
  },
  {
    file: 'export/runtime/scenes/materials/curvature/radial-parts.ts',
    isNeeded: ({ techniqueRadial }) => techniqueRadial,
    otherwise: `export const readsRadial = () => false;
export const RADIAL_FRAGMENT = '';
export const RADIAL_VARYING = '';
export const RADIAL_VERTEX = { declarations: '', main: '' };`,
  },
  {
    file: 'export/runtime/scenes/materials/edges/edge-geometry.ts',
    isNeeded: drawsEdges,
    // Of a mesh without a border.
    otherwise: 'export const edgeGeometryOf = () => null;',
  },
  {
    file: 'export/runtime/scenes/materials/edges/edge-wrapper.ts',
    isNeeded: drawsEdges,
    otherwise: absent('techniqueEdges'),
  },
  {
    file: 'export/runtime/scenes/shadow-layer.ts',
    isNeeded: ({ nodeTypes }) => SHADOW_CATCHERS.some((type) => nodeTypes.includes(type)),
    otherwise: absent('createShadowLayer'),
  },
  {
    file: 'export/runtime/scenes/materials/shadow-strokes.ts',
    isNeeded: plays('layer/shadow', { drawing: 'strokes' }),
    otherwise: `export const GAP = '';\n${absent('createStrokeUniforms', 'gapOf', 'strokeParts')}`,
  },
  {
    file: 'export/runtime/scenes/materials/shadow-contours.ts',
    isNeeded: plays('layer/shadow', { drawing: 'strokes' }),
    otherwise: absent('contourParts', 'flatContour', 'cubeContour'),
  },
  {
    file: 'nodes/layer/shadow/strokes.ts',
    isNeeded: plays('layer/shadow', { drawing: 'strokes' }),
    otherwise: absent('createCasterStrokes'),
  },
  {
    file: 'export/runtime/scenes/volumes/volume-catcher.ts',
    isNeeded: plays('layer/shadow', { method: 'volume' }),
    otherwise: absent('createVolumeCatcher'),
  },
  {
    file: 'export/runtime/scenes/materials/room-surface.ts',
    isNeeded: ({ nodes }) => nodes.some(({ type, inputs }) => SHADOW_CATCHERS.includes(type) && (inputs.depth?.length ?? 0) > 0),
    otherwise: `export const ROOM_SURFACE = { declarations: '', find: '' };\n${absent('createRoomSurface', 'createRoomMaterial')}`,
  },
  {
    file: 'export/runtime/scenes/lights/shadow-maps.ts',
    isNeeded: ({ operationKinds }) => operationKinds.has('shadow-maps'),
    otherwise: absent('createShadowMaps'),
  },
  {
    file: 'export/runtime/scenes/mask-scene.ts',
    isNeeded: plays('layer/object-mask'),
    otherwise: absent('createMaskScene'),
  },
  {
    file: 'export/runtime/scenes/environments/panorama-store.ts',
    isNeeded: hasPanoramas,
    otherwise: `${ABSENT}
export const createPanoramaStore = () => ({ load: absent, create: absent, prefiltered: absent, dispose: () => {} });`,
  },
  {
    file: 'export/runtime/scenes/environments/backdrop.ts',
    isNeeded: hasPanoramas,
    otherwise: absent('createBackdrop'),
  },
  {
    file: 'export/runtime/scenes/environments/probe-environment.ts',
    isNeeded: plays('world/light-estimate'),
    otherwise: absent('createProbeEnvironment'),
  },
  {
    file: 'nodes/world/depth/follow-edges.ts',
    isNeeded: followsEdges,
    otherwise: `export const MAX_SIDE_PX = 0;\n${absent('createEdgeFollower')}`,
  },
  {
    file: 'nodes/world/depth/registration-check.ts',
    isNeeded: followsEdges,
    otherwise: absent('createRegistrationCheck'),
  },
  {
    file: 'nodes/world/depth/confidence.ts',
    isNeeded: ({ nodes }) => nodes.some(({ type, outputs }) => type === 'world/depth' && Object.hasOwn(outputs, 'confidence')),
    otherwise: absent('createConfidenceMeter'),
  },
  {
    file: 'nodes/world/depth/image-depth.ts',
    isNeeded: plays('world/depth', { source: 'picture' }),
    otherwise: absent('createImageDepth'),
  },
];
