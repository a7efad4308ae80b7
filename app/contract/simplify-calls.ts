import { z } from 'zod';
import { diagnostic, handle, programPath, projectPath } from './call-parts.ts';

const simplifier = z.enum(['blender', 'instant-meshes']);

/** Calls that make models and captures of the project smaller with a program of others. */
export const SIMPLIFY_CALLS = {
  /**
   * Counts the triangles of a model, or of the mesh of a capture (the path of its `capture.json`), and looks for the program: `tool` has its
   * version and path, or `diagnostic` says why there is none. `executable` is the path that the user typed; null: that of the setting, or in PATH.
   */
  'simplify.look': {
    input: z.object({ handle, path: projectPath, program: simplifier, executable: programPath }),
    output: z.object({ triangles: z.number(), tool: z.string().nullable(), diagnostic: diagnostic.nullable() }),
  },
  /**
   * Writes a smaller model, or a copy of a capture with a smaller mesh, beside the one before. Reports progress and what the program prints as
   * events, and is canceled by `tool.cancel`. `path` is that of the new asset, for the asset table, which the editor keeps; null if it was
   * canceled.
   */
  'simplify.run': {
    input: z.object({
      handle,
      path: projectPath,
      program: simplifier,
      executable: programPath,
      triangles: z.number().int().min(4).max(4_000_000),
    }),
    output: z.object({ path: projectPath.nullable(), before: z.number(), after: z.number() }),
  },
} as const;
