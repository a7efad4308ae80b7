import type { Operation, PassOperation, Program } from './program.ts';

/** Node types whose runtime reads the pose or the projection of a view. A test compares them with the runtimes. */
export const VIEW_READERS: readonly string[] = [
  'input/gestures',
  'input/head',
  'input/pick',
  'objects/arrow',
  'objects/label',
  'objects/line',
  'objects/place',
  'output/sound',
  'physics/room',
  'pose/geo',
  'source/capture',
  'source/splats',
  'world/depth',
  'world/measure',
  'world/surface-filter',
];

/**
 * Whether the image of a program depends on the pose or the projection of the view, or on where the visitor points. Where it does not, as
 * where effects filter an image or the camera video, looking around changes nothing.
 */
export function readsView({
  operations,
  assets,
  needs,
  readsInput,
}: Pick<Program, 'operations' | 'assets' | 'needs' | 'readsInput'>): boolean {
  return (
    drawsScenes({ operations, assets }) ||
    readsInput === true ||
    needs.some(({ capability }) => capability !== 'camera-image') ||
    operations.some((operation) => (operation.kind === 'pass' ? passReadsView(operation) : 'type' in operation && nodeReadsView(operation)))
  );
}

function nodeReadsView(operation: Extract<Operation, { readonly type: string }>): boolean {
  return operation.poses !== undefined || VIEW_READERS.includes(operation.type) || operation.type === 'source/panorama-capture';
}

/** Whether three.js draws or reads something. */
export function drawsScenes({ operations, assets }: Pick<Program, 'operations' | 'assets'>): boolean {
  const files = new Set(assets.flatMap(({ id, kind }) => (kind === 'model' || kind === 'environment' ? [id] : [])));
  return operations.some(
    (operation) =>
      operation.kind === 'geometry' ||
      operation.kind === 'shadow-maps' ||
      (operation.kind === 'draw' && !('ownDrawing' in operation)) ||
      ('type' in operation && Object.values(operation.assets).some((id) => id !== null && files.has(id))),
  );
}

/** Whether a pass reads the pose or the projection of its view. */
export function passReadsView({ uniforms }: Pick<PassOperation, 'uniforms'>): boolean {
  return uniforms.some(
    ({ source }) => 'builtin' in source && (source.builtin === 'SCRIM_CLIP_FROM_VIEW' || source.builtin === 'SCRIM_WORLD_FROM_VIEW'),
  );
}
