import type { PassOperation } from './program.ts';

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

/** Whether a pass reads the pose or the projection of its view. */
export function passReadsView({ uniforms }: Pick<PassOperation, 'uniforms'>): boolean {
  return uniforms.some(
    ({ source }) => 'builtin' in source && (source.builtin === 'SCRIM_CLIP_FROM_VIEW' || source.builtin === 'SCRIM_WORLD_FROM_VIEW'),
  );
}
