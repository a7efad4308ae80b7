import { type Gltf, ModelError } from './document.ts';
import { externalFiles, packGlb } from './pack-glb.ts';
import { readGltf } from './read-gltf.ts';

/** A model with all of its data. */
export interface WholeModel {
  /** The file itself, or a GLB with the external files. */
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly gltf: Gltf;
}

/**
 * Reads a model and the files that it refers to.
 *
 * @param path Path of the model; references are relative to it.
 * @param readFile Rejects with an `Error` whose message is text for the user.
 * @throws ModelError if the model is invalid.
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
