import { rmSync } from 'node:fs';
import { mkdtemp, rename, rm, writeFile } from 'node:fs/promises';
import { basename, dirname, join, resolve } from 'node:path';
import process from 'node:process';
import { encodeDepth, encodeLayer } from '../../services/encode-png.ts';
import { writeRefusal } from '../../services/file-errors.ts';
import { makeFolders } from '../../services/make-folders.ts';
import type { ImageHead } from './render.page.ts';

/** Collects images in a temporary folder until all are complete, so that a failed render leaves nothing. */
export interface FrameWriter {
  /**
   * Encodes an image and writes it to the temporary folder.
   *
   * @param bytes Premultiplied RGBA, or depth in meters as 32-bit floats.
   */
  add(index: number, head: ImageHead, bytes: Uint8Array): Promise<void>;
  /** Moves the images to their destination. Returns their paths. */
  finish(): Promise<readonly string[]>;
  dispose(): Promise<void>;
}

/**
 * Creates a frame writer and its temporary folder.
 *
 * @throws SCR060 if `out` cannot be written, before anything is rendered
 */
export async function createFrameWriter(out: string, isFile: boolean, isDepth: boolean): Promise<FrameWriter> {
  const folder = isFile ? dirname(resolve(out)) : resolve(out);
  const refuse = (error: unknown): never => {
    throw writeRefusal(error, out);
  };
  const firstMade = await makeFolders(folder).catch(refuse);
  const aside = await mkdtemp(join(folder, '.scrim-render-')).catch(refuse);
  const names: string[] = [];
  let finished = false;
  // On an interrupt the browser driver ends the process, without running `finally` blocks.
  const sweep = () => {
    rmSync(aside, { recursive: true, force: true });
    if (!finished && firstMade !== undefined) rmSync(firstMade, { recursive: true, force: true });
  };
  process.once('exit', sweep);
  return {
    add: async (index, { widthPx, heightPx }, bytes) => {
      const name = isFile ? basename(out) : `${String(index).padStart(6, '0')}.png`;
      const png = isDepth
        ? encodeDepth({ widthPx, heightPx, meters: new Float32Array(Uint8Array.from(bytes).buffer) })
        : encodeLayer({ widthPx, heightPx, pixels: bytes });
      await writeFile(join(aside, name), png).catch(refuse);
      names.push(name);
    },
    finish: async () => {
      for (const name of names) await rename(join(aside, name), join(folder, name)).catch(refuse);
      finished = true;
      return names.map((name) => (isFile ? out : join(out, name)));
    },
    dispose: async () => {
      process.off('exit', sweep);
      await rm(aside, { recursive: true, force: true });
      if (!finished && firstMade !== undefined) await rm(firstMade, { recursive: true, force: true });
    },
  };
}
