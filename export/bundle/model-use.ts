import type { GltfDocument } from '../gltf/document.ts';

/** Features of models that decide which parts of three.js a page needs. */
export interface ModelUse {
  /** glTF extensions of all models. */
  readonly extensions: ReadonlySet<string>;
  /** Whether a model has points. */
  readonly points: boolean;
  /** Whether a surface of a model may have a border. */
  readonly open: boolean;
}

/** Mode of glTF's primitives that are points. */
const POINTS = 0;

/** Finds the features of models. Materials name their extensions, which not all files list at their top. */
export function modelUse(documents: readonly GltfDocument[], open: boolean): ModelUse {
  const extensions = documents.flatMap(({ extensionsUsed = [], materials = [] }) => [
    ...extensionsUsed,
    ...materials.flatMap((material) => Object.keys(material.extensions ?? {})),
  ]);
  const points = documents.some(({ meshes = [] }) => meshes.some(({ primitives }) => primitives.some(({ mode }) => mode === POINTS)));
  return { extensions: new Set(extensions), points, open };
}
