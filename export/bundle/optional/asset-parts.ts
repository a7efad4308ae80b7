import { absent, hasPanoramas, type OptionalPart } from './part.ts';

/** Parts that load assets. */
export const ASSET_PARTS: readonly OptionalPart[] = [
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
    file: 'nodes/kit/capture-drawing/windowed/windowed-drawing.ts',
    isNeeded: ({ vertexWeights }) => vertexWeights,
    otherwise: absent('createWindowedDrawing'),
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
];
