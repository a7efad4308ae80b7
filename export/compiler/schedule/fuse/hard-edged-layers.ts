import type { ResourceId } from '../../../program/program.ts';
import type { ScheduledOperation } from '../scheduled.ts';

/** Types of sources that show a file. */
export const FILE_SOURCES: ReadonlySet<string> = new Set(['source/image-file', 'source/video-file']);

/**
 * Layers of sources whose alpha is 0 or 1 in each pixel, with the color 0 where alpha is: the image of the camera, which is transparent only
 * where there is none, and image and video files without transparency, which are transparent until they are loaded.
 *
 * @param opaqueImages Ids of image and video assets without transparency.
 */
export function hardEdgedLayers(operations: readonly ScheduledOperation[], opaqueImages: ReadonlySet<string>): ReadonlySet<ResourceId> {
  return new Set(
    operations.flatMap((operation) => {
      if (operation.kind !== 'source') return [];
      const { type, config, assets, writes } = operation;
      const isHard =
        (type === 'source/camera-video' && config.withoutImage === 'transparent') ||
        (FILE_SOURCES.has(type) && opaqueImages.has(assets.file ?? ''));
      return isHard ? writes : [];
    }),
  );
}
