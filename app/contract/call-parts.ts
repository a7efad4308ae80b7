import { z } from 'zod';

/* What several calls of the contract contain. */

export const diagnostic = z.object({
  code: z.string().regex(/^SCR\d{3}$/),
  severity: z.enum(['error', 'warning', 'info']),
  message: z.string(),
  nodeId: z.string().optional(),
  port: z.string().optional(),
  file: z.string().optional(),
  line: z.number().optional(),
  column: z.number().optional(),
  fix: z.string().optional(),
});

/** Text of a JSON document of a project. */
export const documentText = z.string().max(64 * 2 ** 20);

/** The files of a project as texts. */
export const projectFiles = z.object({
  /** Text of `project.scrim.json`. */
  project: documentText,
  /** Text of `project.layout.json`; null if there is none. */
  layout: documentText.nullable(),
  /** Texts of the files in `shaders/`, by file name. */
  sources: z.record(z.string(), z.string().max(4 * 2 ** 20)),
});

/** Id of an open project. Valid while it is open. Never a path. */
export const handle = z.string().regex(/^[a-z0-9]{16,64}$/);

/** Path relative to the project folder, with `/`. The host rejects paths that leave the folder. */
export const projectPath = z.string().min(1).max(512);

/** Limit for an imported asset: larger than any model that a phone can load, and small enough for memory. */
export const MAX_ASSET_BYTES = 512 * 2 ** 20;

/** Whether bytes are not more than an asset may have. */
export function isWithinLimit(bytes: Uint8Array): boolean {
  return bytes.length <= MAX_ASSET_BYTES;
}

/** Side of a rendered image in pixels. */
export const side = z.number().int().min(1).max(8192);

export const pictureSize = z.object({ widthPx: side, heightPx: side });

/** Path of a program that the user typed; null if none. */
export const programPath = z.string().min(1).max(4096).nullable();
