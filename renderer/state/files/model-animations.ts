import { animationNames } from '../../../export/gltf/animation-names.ts';
import { type ModelBounds, modelBounds } from '../../../export/gltf/model-bounds.ts';
import { readGltf } from '../../../export/gltf/read-gltf.ts';
import type { Editor } from '../editor/editor.ts';
import { bytesOf } from './base64.ts';

/** The whole file is read for the names. */
const MAX_BYTES = 64 * 2 ** 20;

export interface ModelFile {
  readonly handle: string;
  readonly path: string;
  /** Size on disk, if it is known. */
  readonly bytes: number | undefined;
}

/** The names of the animations of a model; null if the file is missing, invalid or too large to be read for them. Never rejects. */
export async function readAnimations(editor: Editor, file: ModelFile): Promise<readonly string[] | null> {
  return readModel(editor, file, (bytes) => animationNames(readGltf(bytes)));
}

/** The box around a model of the project; null if the file is missing, invalid or too large to be read for it. Never rejects. */
export async function readBoundsOf(editor: Editor, file: ModelFile): Promise<ModelBounds | null> {
  return readModel(editor, file, readBounds);
}

/** The box around a model; null if the file is invalid. */
export function readBounds(bytes: Uint8Array): ModelBounds | null {
  try {
    return modelBounds(readGltf(bytes));
  } catch {
    // The check of the project says what is wrong with the file.
    return null;
  }
}

async function readModel<T>({ host }: Editor, { handle, path, bytes = 0 }: ModelFile, read: (bytes: Uint8Array) => T): Promise<T | null> {
  if (bytes > MAX_BYTES) return null;
  try {
    const { base64 } = await host.call('asset.read', { handle, path });
    return read(bytesOf(base64));
  } catch {
    // The check of the project says what is wrong with the file.
    return null;
  }
}
