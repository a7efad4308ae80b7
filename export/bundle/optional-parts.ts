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

function absent(...names: readonly string[]): string {
  const text = names.map((name) => `absent as ${name}`).join(', ');
  return `const absent = () => { throw new Error('The page was made without this.'); };\nexport { ${text} };`;
}

const needs = (capability: string) => (use: PageUse) => use.capabilities.has(capability as never);

/** Node types that read `SessionService.cameraMean`. A test compares them with the runtimes. */
export const CAMERA_MEAN_READERS: readonly string[] = ['layer/negative-shadow', 'world/light-estimate'];

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
    isNeeded: ({ scenes }) => scenes,
    otherwise: absent('createLiveTechnique', 'layerView'),
  },
  {
    file: 'export/runtime/resources/live-curve.ts',
    isNeeded: ({ resourceKinds }) => resourceKinds.has('curve'),
    otherwise: absent('createLiveCurve'),
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
