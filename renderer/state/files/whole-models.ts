import { type Gltf, ModelError } from '../../../export/gltf/document.ts';
import { externalFiles, packGlb } from '../../../export/gltf/pack-glb.ts';
import { readGltf } from '../../../export/gltf/read-gltf.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';

export interface ModelFile {
  readonly name: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

export interface WholeModel {
  /** The model as one file; null if files are missing, as `diagnostic` says. */
  readonly file: ModelFile | null;
  readonly diagnostic: Diagnostic | null;
  /** Paths of all files that the model refers to, including missing ones. */
  readonly beside: readonly string[];
}

/**
 * Packs a `.gltf` and the files that it refers to into one `.glb`, because an import renames files and would break the references.
 * Returns other files and invalid models unchanged; their problems are reported when they are drawn.
 *
 * @param path Path of the model. The files that it refers to are relative to the same folder.
 * @param fix Remedy for missing files.
 * @param read Reads a file; null if it does not exist.
 */
export async function wholeModel(
  path: string,
  bytes: Uint8Array<ArrayBuffer>,
  fix: string,
  read: (path: string) => Promise<Uint8Array | null>,
): Promise<WholeModel> {
  const name = path.slice(path.lastIndexOf('/') + 1);
  const unchanged: WholeModel = { file: { name, bytes }, diagnostic: null, beside: [] };
  const gltf = isGltf(name) ? readOrNull(bytes, path) : null;
  if (gltf === null) return unchanged;
  const files = new Map<string, Uint8Array>();
  const missing: string[] = [];
  for (const [uri, file] of gltf.refersTo) {
    const content = await read(file);
    if (content === null) missing.push(decodeURIComponent(uri));
    else files.set(uri, content);
  }
  const beside = [...gltf.refersTo.values()];
  if (missing.length > 0) {
    const message = `${name} is incomplete. It refers to ${listed(missing)}, which ${missing.length === 1 ? 'is' : 'are'} missing.`;
    return { file: null, diagnostic: { code: 'SCR030', severity: 'error', message, fix }, beside };
  }
  try {
    return { file: { name: name.replace(/gltf$/i, 'glb'), bytes: packGlb(gltf, files) }, diagnostic: null, beside };
  } catch (error) {
    if (!(error instanceof ModelError)) throw error;
    const message = `${name} cannot be decoded: ${error.message}`;
    return { file: null, diagnostic: { code: 'SCR032', severity: 'error', message }, beside };
  }
}

/** Whether the bytes begin with the magic number of a .glb file (glTF 2.0, §4.4.2). */
export function isGlb(bytes: Uint8Array): boolean {
  return String.fromCharCode(...bytes.subarray(0, 4)) === 'glTF';
}

export function isGltf(name: string): boolean {
  return /\.gltf$/i.test(name);
}

function readOrNull(bytes: Uint8Array, path: string): (Gltf & { readonly refersTo: ReadonlyMap<string, string> }) | null {
  try {
    const gltf = readGltf(bytes);
    return { ...gltf, refersTo: externalFiles(gltf.document, path) };
  } catch {
    // The problem is reported when the model is drawn.
    return null;
  }
}

function listed(names: readonly string[]): string {
  const quoted = names.map((name) => `“${name}”`);
  return [quoted.slice(0, -1).join(', '), quoted.at(-1)].filter(Boolean).join(' and ');
}
