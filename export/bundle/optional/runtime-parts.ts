import { absent, type OptionalPart } from './part.ts';

/** Node types that read `SessionService.cameraMean`. A test compares them with the runtimes. */
export const CAMERA_MEAN_READERS: readonly string[] = ['layer/negative-shadow', 'world/light-estimate'];

/** Parts that play values, passes, sound and filters. */
export const RUNTIME_PARTS: readonly OptionalPart[] = [
  {
    file: 'export/runtime/light/camera-mean.ts',
    isNeeded: ({ nodeTypes }) => CAMERA_MEAN_READERS.some((type) => nodeTypes.includes(type)),
    otherwise: absent('createCameraMean'),
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
    file: 'export/runtime/operations/material-effects.ts',
    isNeeded: ({ materialEffects }) => materialEffects,
    otherwise: 'export const createMaterialEffects = () => null;',
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
    // The loops of a page are not bounded.
    file: 'export/runtime/passes/guarded-drawing.ts',
    isNeeded: () => false,
    otherwise: absent('createGate', 'guardDrawing'),
  },
  {
    file: 'export/runtime/passes/change-watch.ts',
    isNeeded: ({ passesOnce, mayRest }) => passesOnce || mayRest,
    otherwise: 'export const createChangeWatch = () => null;',
  },
  {
    file: 'export/runtime/program-instance/prepare-materials.ts',
    isNeeded: ({ scenes }) => scenes,
    otherwise: 'export const prepareMaterials = async () => {};',
  },
  {
    file: 'export/runtime/program-instance/missing-floats.ts',
    isNeeded: ({ targetFormats }) => targetFormats.has('scene16f'),
    otherwise: 'export const reportMissingFloats = () => {};',
  },
  {
    file: 'export/runtime/operations/occlusion.ts',
    isNeeded: ({ operationKinds }) => operationKinds.has('draw'),
    otherwise: 'export const createOcclusion = () => null;',
  },
  {
    file: 'export/runtime/operations/pulse-overflow.ts',
    isNeeded: ({ pulses }) => pulses,
    otherwise: 'export const reportOverflows = () => {};',
  },
  {
    // The compiler has checked the assets of a page.
    file: 'export/runtime/assets/asset-mistakes.ts',
    isNeeded: () => false,
    otherwise: absent('missing', 'wrongKind'),
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
    otherwise: 'export const STILL_TYPES = [];\nexport const MOVED_TYPES = [];\nexport const mayRest = () => true;',
  },
  {
    file: 'export/runtime/passes/direct-draw.ts',
    isNeeded: ({ passesOnce, mayRest }) => passesOnce && mayRest,
    otherwise: 'export const findDirectDraws = () => new Map();',
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
];
