import { resolve } from 'node:path';
import type { Plugin } from 'esbuild';
import type { PageUse } from './page-entry.ts';

/** A source file of the runtime that only some pages need. */
interface OptionalPart {
  /** Path relative to the root. */
  readonly file: string;
  /** Whether the page needs it. */
  readonly isNeeded: (use: PageUse) => boolean;
  /** Code that stands for the file in other pages. `absent` throws when it is called: nothing of such a page calls it. */
  readonly otherwise: string;
}

const ABSENT = `const absent = () => { throw new Error('The page was made without this.'); };`;

function absent(...names: readonly string[]): string {
  const text = names.map((name) => `absent as ${name}`).join(', ');
  return `${ABSENT}\nexport { ${text} };`;
}

const WRITE_IDENTITY = '(m) => { m[0] = m[5] = m[10] = m[15] = 1; }';

const readsView = (use: PageUse): boolean => use.readsView;

const needs = (capability: string) => (use: PageUse) => use.capabilities.has(capability as never);

/** Node types that read `SessionService.cameraMean`. A test compares them with the runtimes. */
export const CAMERA_MEAN_READERS: readonly string[] = ['layer/negative-shadow', 'world/light-estimate'];

const plays =
  (type: string, config: Readonly<Record<string, string>> = {}) =>
  ({ nodes }: PageUse): boolean =>
    nodes.some((node) => node.type === type && Object.entries(config).every(([param, value]) => node.config[param] === value));

/** Whether the room depth of a program follows the edges of the camera image. */
const followsEdges = (use: PageUse): boolean =>
  plays('world/depth', { filter: 'by-sensor' })(use) || plays('world/depth', { filter: 'edge-aware' })(use);

/** Node types that create panoramas from pixels. A test compares them with the runtimes. */
export const PANORAMA_MAKERS: readonly string[] = ['source/panorama-capture', 'source/panorama-exposures'];

const hasPanoramas = ({ panoramas, nodeTypes }: PageUse): boolean => panoramas || PANORAMA_MAKERS.some((type) => nodeTypes.includes(type));

/** Node types that draw shadows. A test compares them with the runtimes. */
export const SHADOW_CATCHERS: readonly string[] = ['layer/negative-shadow', 'layer/shadow'];

/**
 * The parts of the runtime and the page that the compiler's output decides about (ADR 44). The player imports them like any other file; the
 * bundler replaces those that a page does not need.
 */
export const OPTIONAL_PARTS: readonly OptionalPart[] = [
  {
    file: 'export/runtime/light/camera-mean.ts',
    isNeeded: ({ nodeTypes }) => CAMERA_MEAN_READERS.some((type) => nodeTypes.includes(type)),
    otherwise: absent('createCameraMean'),
  },
  {
    file: 'export/runtime/assets/video/load-video.ts',
    isNeeded: ({ assetKinds }) => assetKinds.has('video'),
    otherwise: absent('loadVideo'),
  },
  {
    file: 'export/runtime/assets/load-audio.ts',
    isNeeded: ({ assetKinds }) => assetKinds.has('audio'),
    otherwise: absent('loadAudio'),
  },
  {
    file: 'export/runtime/assets/capture/load-capture.ts',
    isNeeded: ({ assetKinds }) => assetKinds.has('capture'),
    otherwise: absent('loadCapture'),
  },
  {
    file: 'export/runtime/assets/capture/load-depth-meshes.ts',
    isNeeded: ({ depthMeshes }) => depthMeshes,
    otherwise: absent('loadDepthMeshes'),
  },
  {
    file: 'nodes/kit/capture-drawing/depth-meshes/depth-mesh-drawing.ts',
    isNeeded: ({ depthMeshes }) => depthMeshes,
    otherwise: absent('createDepthMeshDrawing'),
  },
  {
    file: 'export/runtime/assets/splats/load-splats.ts',
    isNeeded: ({ assetKinds }) => assetKinds.has('splats'),
    otherwise: absent('loadSplats'),
  },
  {
    // The export packs PLY files.
    file: 'nodes/kit/splats/splat-ply.ts',
    isNeeded: () => false,
    otherwise: `export const MAX_PLY_HEADER_BYTES = 0;\n${absent('readSplatPly', 'readSplatPlyHeader')}`,
  },
  {
    file: 'export/runtime/assets/load-image.ts',
    isNeeded: ({ assetKinds }) => assetKinds.has('image'),
    otherwise: absent('loadImage'),
  },
  {
    file: 'export/runtime/sound/live-sound.ts',
    isNeeded: ({ resourceKinds }) => resourceKinds.has('sound'),
    otherwise: absent('createLiveSound'),
  },
  {
    file: 'export/runtime/cpu/run-cpu-filter.ts',
    isNeeded: ({ operationKinds }) => operationKinds.has('cpu'),
    otherwise: absent('createCpuFilter'),
  },
  {
    file: 'export/runtime/cpu/cpu-step.ts',
    isNeeded: ({ operationKinds }) => operationKinds.has('cpu'),
    otherwise: `export const isCpu = () => false;\n${absent('createCpuStep')}`,
  },
  {
    file: 'export/runtime/pixels/live-pixels.ts',
    isNeeded: ({ operationKinds }) => operationKinds.has('readback'),
    otherwise: absent('createLivePixels'),
  },
  {
    file: 'export/runtime/pixels/pixels-step.ts',
    isNeeded: ({ operationKinds }) => operationKinds.has('readback'),
    otherwise: `export const isReadback = () => false;\n${absent('createReadbackStep')}`,
  },
  {
    file: 'export/runtime/cpu/worker-source.ts',
    isNeeded: ({ workers, panoramas, takesPanorama }) => workers || panoramas || takesPanorama,
    otherwise: absent('startBlobWorker'),
  },
  {
    file: 'export/runtime/resources/live-technique.ts',
    isNeeded: ({ scenes, resourceKinds, operationKinds }) => scenes && (resourceKinds.has('technique') || operationKinds.has('draw')),
    otherwise: absent('createLiveTechnique', 'layerView'),
  },
  {
    file: 'export/runtime/resources/live-curve.ts',
    isNeeded: ({ tableTypes }) => tableTypes.has('curve'),
    otherwise: absent('createLiveCurve'),
  },
  {
    file: 'export/runtime/resources/live-gradient.ts',
    isNeeded: ({ tableTypes }) => tableTypes.has('gradient'),
    otherwise: absent('createLiveGradient'),
  },
  {
    file: 'export/runtime/program-instance/draw-step.ts',
    isNeeded: ({ operationKinds }) => operationKinds.has('draw'),
    otherwise: absent('createDrawStep'),
  },
  {
    file: 'export/runtime/targets/multisampling.ts',
    isNeeded: ({ operationKinds }) => operationKinds.has('draw'),
    otherwise: absent('createMultisampling'),
  },
  {
    file: 'export/runtime/passes/imports.ts',
    isNeeded: ({ importsImages }) => importsImages,
    otherwise: `export const createImports = () => ({ release() {} });`,
  },
  {
    file: 'export/runtime/passes/change-watch.ts',
    isNeeded: ({ passesOnce, mayRest }) => passesOnce || mayRest,
    otherwise: 'export const createChangeWatch = () => null;',
  },
  {
    file: 'export/runtime/program-instance/rest-watch.ts',
    isNeeded: ({ objectsMayRest }) => objectsMayRest,
    otherwise: 'export const createRestWatch = () => null;',
  },
  {
    // The page has the watch above only if its program may rest.
    file: 'export/program/may-rest.ts',
    isNeeded: () => false,
    otherwise: 'export const STILL_TYPES = [];\nexport const mayRest = () => true;',
  },
  {
    file: 'export/runtime/passes/direct-draw.ts',
    isNeeded: ({ passesOnce, mayRest }) => passesOnce && mayRest,
    otherwise: 'export const findDirectDraws = () => new Map();',
  },
  {
    file: 'export/runtime/gl/image-store.ts',
    isNeeded: ({ scenes }) => scenes,
    otherwise: `export const createImageStore = () => ({ hold: () => ({ release() {} }), texture: () => null });`,
  },
  {
    file: 'export/runtime/values/pulses.ts',
    isNeeded: ({ pulses }) => pulses,
    otherwise: absent('createPulseQueue', 'createMergedPulses'),
  },
  {
    file: 'export/runtime/values/pose-input.ts',
    isNeeded: ({ poses }) => poses,
    otherwise: absent('createPoseInput'),
  },
  {
    file: 'export/page/control-elements.ts',
    isNeeded: ({ controls }) => controls,
    otherwise: `export const createControls = () => null;\n${absent('sliderText')}`,
  },
  {
    file: 'export/page/credits-list.ts',
    isNeeded: ({ credits }) => credits,
    otherwise: 'export const createCredits = () => [];',
  },
  {
    file: 'export/page/embedded-files.ts',
    isNeeded: ({ singleFile }) => singleFile,
    otherwise: `export const hasEmbeddedFiles = () => false;\n${absent('createEmbeddedAssetSource')}`,
  },
  {
    file: 'export/runtime/assets/asset-source.ts',
    isNeeded: ({ singleFile }) => !singleFile,
    otherwise: absent('createFetchAssetSource'),
  },
  {
    file: 'export/runtime/assets/asset-store.ts',
    isNeeded: (use) => use.assetKinds.size > 0 || hasPanoramas(use),
    otherwise: `const loaded = Promise.resolve();
const nothing = () => {};
export const createAssetStore = () => ({ hold: () => ({ usable: loaded, settled: loaded, release: nothing }), serviceFor: nothing, dispose: nothing });`,
  },
  {
    file: 'export/runtime/sessions/orbit/orbit-input.ts',
    isNeeded: readsView,
    otherwise: 'const nothing = () => {};\nexport const listenForOrbit = () => ({ settle: nothing, dispose: nothing });',
  },
  {
    file: 'export/runtime/sessions/orbit/orbit-pose.ts',
    isNeeded: readsView,
    otherwise: `export const ORBIT_DEFAULTS = {};\nexport const createOrbit = () => ({ writeWorldFromView: ${WRITE_IDENTITY} });`,
  },
  {
    file: 'export/runtime/sessions/camera/camera-viewer.ts',
    isNeeded: readsView,
    otherwise: `export const createCameraViewer = () => ({ writeWorldFromView: ${WRITE_IDENTITY} });`,
  },
  {
    // Without it, iPhones do not ask the visitor for the motion sensor.
    file: 'export/runtime/sessions/camera/orientation-sensor.ts',
    isNeeded: readsView,
    otherwise: `export const requestOrientationPermission = async () => 'absent';
export const listenForOrientation = () => ({ present: true, dispose: () => {} });`,
  },
  {
    file: 'export/runtime/sessions/input/session-input.ts',
    isNeeded: (use) => use.input || needs('planes')(use),
    otherwise: `export const MAX_POINTERS = 0;
export const MAX_TAPS = 0;
export const MAX_KEYS = 0;
export const createSessionInput = () => ({});
${absent('createPointer', 'addPointer', 'deriveTaps', 'rest', 'nextTap')}`,
  },
  {
    file: 'export/runtime/targets/target.ts',
    isNeeded: ({ resourceKinds }) => resourceKinds.has('target'),
    otherwise: `export const MAX_VIEWS = 2;\n${absent('createTarget')}`,
  },
  {
    file: 'export/runtime/targets/target-sizes.ts',
    isNeeded: ({ resourceKinds }) => resourceKinds.has('target'),
    otherwise: `const nothing = () => {};
export const createTargetSizes = () => ({ resizeImages: nothing, resizeViews: nothing, trim: nothing });`,
  },
  {
    file: 'export/runtime/targets/evaluate-size.ts',
    isNeeded: ({ computedSizes }) => computedSizes,
    otherwise: `export const evaluateSize = ([token], widthPx, heightPx, slots, maxPx) =>
  Math.min(Math.max(Math.floor(token.op === 'width' ? widthPx : heightPx), 1), maxPx);`,
  },
  {
    // Nodes of a program that is never replaced are found by any key.
    file: 'export/runtime/operations/node-key.ts',
    isNeeded: ({ takesPanorama }) => takesPanorama,
    otherwise: `export const nodeKey = ({ id }) => id;
export const shadowMapsKey = ({ id }) => id;
export const isDraw = ({ kind }) => kind === 'draw';`,
  },
  {
    file: 'export/runtime/sessions/webxr/authored-room.ts',
    isNeeded: ({ tiers }) => tiers.has('authored-vr'),
    otherwise: absent('createAuthoredRoom'),
  },
  {
    file: 'export/runtime/sessions/webxr/webxr-light.ts',
    isNeeded: needs('light-estimation'),
    otherwise: absent('createWebXrLight'),
  },
  {
    file: 'export/runtime/sessions/webxr/webxr-detected-surfaces.ts',
    isNeeded: (use) => needs('planes')(use) || needs('meshes')(use),
    otherwise: 'export const createSurfaceReader = () => null;',
  },
  {
    file: 'export/runtime/sessions/webxr/room-capture.ts',
    isNeeded: needs('planes'),
    otherwise: 'export const createRoomCapture = () => null;',
  },
  {
    file: 'export/runtime/sessions/webxr/cpu-depth.ts',
    isNeeded: needs('depth'),
    otherwise: absent('createCpuDepth'),
  },
  {
    file: 'export/runtime/sessions/webxr/gpu-depth.ts',
    isNeeded: needs('depth'),
    otherwise: absent('createGpuDepth'),
  },
  {
    file: 'export/runtime/sessions/webxr/reproject-depth.ts',
    isNeeded: needs('depth'),
    otherwise: absent('createDepthReprojector', 'isSameMatrix', 'isSameLens'),
  },
  {
    // The models of a page were checked when it was exported.
    file: 'export/gltf/whole-model.ts',
    isNeeded: () => false,
    otherwise: `export { readPreparedModel as readWholeModel } from './prepared-model.ts';`,
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
    isNeeded: ({ techniqueEdges }) => techniqueEdges,
    otherwise: 'export const edgeGeometryOf = () => null;',
  },
  {
    file: 'export/runtime/scenes/materials/edges/edge-wrapper.ts',
    isNeeded: ({ techniqueEdges }) => techniqueEdges,
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
    otherwise: absent('createStrokeUniforms', 'strokeParts'),
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

/** Replaces the optional parts that a page does not need. */
export function leaveOut(root: string, use: PageUse): Plugin {
  const replaced = new Map(
    OPTIONAL_PARTS.filter(({ isNeeded }) => !isNeeded(use)).map(({ file, otherwise }) => [resolve(root, file), otherwise]),
  );
  return {
    name: 'leave-out',
    setup: ({ onLoad }) => {
      onLoad({ filter: /\.ts$/ }, ({ path }) => {
        const contents = replaced.get(path);
        return contents === undefined ? null : { contents, loader: 'ts' };
      });
    },
  };
}
