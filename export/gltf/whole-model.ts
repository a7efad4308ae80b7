import { type Gltf, ModelError } from './document.ts';
import { externalFiles, packGlb } from './pack-glb.ts';
import { readGltf } from './read-gltf.ts';

/** A model with everything that belongs to it. */
export interface WholeModel {
  /** The file itself where nothing was outside of its one buffer, else a GLB made of it. */
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly gltf: Gltf;
}

/**
 * Reads a model and the files that it refers to.
 *
 * @param path of the model; those of the files stand beside it
 * @param readFile rejects with an `Error` that says why there is no such file
 * @throws ModelError
 */
export async function readWholeModel(
  bytes: Uint8Array<ArrayBuffer>,
  path: string,
  readFile: (path: string) => Promise<Uint8Array>,
): Promise<WholeModel> {
  const gltf = readGltf(bytes);
  const { buffers = [], images = [] } = gltf.document;
  if (gltf.binary !== null && [...buffers, ...images].every(({ uri }) => uri === undefined)) return { bytes, gltf };
  const files = new Map<string, Uint8Array>();
  await Promise.all(
    [...externalFiles(gltf.document, path)].map(async ([uri, file]) => {
      const content = await readFile(file).catch((error: unknown) => {
        const reason = error instanceof Error ? error.message : String(error);
        throw new ModelError(
          `the file "${uri}" that it refers to cannot be read (${reason.replace(/\.$/, '')}). Put it beside the model, or export one .glb file.`,
        );
      });
      files.set(uri, content);
    }),
  );
  const packed = packGlb(gltf, files);
  return { bytes: packed, gltf: readGltf(packed) };
}
