import { z } from 'zod';
import { handle, isWithinLimit, pictureSize, projectPath } from './call-parts.ts';

const rephotographMethod = z.enum(['plain', 'nearest', 'lumigraph', 'depth-meshes']);

/** How well a photograph is shown: `ImageQuality`. Null: no pixel is compared, or for `psnrDb` both are equal. */
const imageQuality = {
  psnrDb: z.number().nullable(),
  ssim: z.number().nullable(),
  chromaError: z.number().nullable(),
  covered: z.number().nullable(),
};

/** Calls with which the editor rephotographs a capture. The host writes the report. */
export const REPHOTOGRAPH_CALLS = {
  /**
   * Begins the report of a capture, in `reports/NAME`: each photograph drawn from all others. `path`: its `capture.json`. `method`: null for
   * all that it can be drawn by. SCR061 unless the folder is missing, empty, or contains an earlier report. One at a time per project.
   */
  'rephotograph.begin': {
    input: z.object({ handle, path: projectPath, method: rephotographMethod.nullable(), blended: z.number().int().min(1).max(4) }),
    output: z.object({ methods: z.array(rephotographMethod), views: z.number() }),
  },
  /**
   * Adds what was drawn of a photograph by one method: in order, each photograph by all methods. `picture` and `error`: RGBA, rows from the
   * top. After an error the report is deleted.
   */
  'rephotograph.add': {
    input: z.object({
      handle,
      index: z.number().int().min(0).max(999),
      method: rephotographMethod,
      size: pictureSize,
      ...imageQuality,
      picture: z.instanceof(Uint8Array).refine(isWithinLimit, 'too large'),
      error: z.instanceof(Uint8Array).refine(isWithinLimit, 'too large'),
    }),
    output: z.object({}),
  },
  /** Completes the report. Gives the means over all photographs. */
  'rephotograph.finish': {
    input: z.object({ handle }),
    output: z.object({ means: z.array(z.object({ method: rephotographMethod, ...imageQuality })) }),
  },
  /** Cancels a report and deletes its files. */
  'rephotograph.cancel': { input: z.object({ handle }), output: z.object({}) },
  /** Serves the report of a capture, as `export.show` does a page. SCR004 if it has none. */
  'rephotograph.show': {
    input: z.object({ handle, path: projectPath }),
    output: z.object({ url: z.string(), opened: z.boolean() }),
  },
} as const;
