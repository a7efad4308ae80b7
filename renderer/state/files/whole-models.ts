import { type Gltf, ModelError } from '../../../export/gltf/document.ts';
import { externalFiles, packGlb } from '../../../export/gltf/pack-glb.ts';
import { readGltf } from '../../../export/gltf/read-gltf.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';

export interface ModelFile {
  readonly name: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

export interface WholeModel {
  /** One file with everything in it; null where something is missing, which `diagnostic` names. */
  readonly file: ModelFile | null;
  readonly diagnostic: Diagnostic | null;
  /** The files that belong to the model, missing ones included. */
  readonly beside: readonly string[];
}

/**
 * A `.gltf` and the files that it refers to as one `.glb`: names of files change on their way into a project, and references do not
 * know. Any other file stays as it is, and so does what cannot be read: those who draw it say why.
 *
 * @param path of the model; those of the files that it refers to are relative to the same folder
 * @param fix what to do about files that are missing
 * @param read null where there is no such file
 */
export async function wholeModel(
  path: string,
  bytes: Uint8Array<ArrayBuffer>,
  fix: string,
  read: (path: string) => Promise<Uint8Array | null>,
): Promise<WholeModel> {
  const name = path.slice(path.lastIndexOf('/') + 1);
  const asItIs: WholeModel = { file: { name, bytes }, diagnostic: null, beside: [] };
  const gltf = isGltf(name) ? readOrNull(bytes, path) : null;
  if (gltf === null) return asItIs;
  const files = new Map<string, Uint8Array>();
  const missing: string[] = [];
  for (const [uri, file] of gltf.refersTo) {
    const content = await read(file);
    if (content === null) missing.push(decodeURIComponent(uri));
    else files.set(uri, content);
  }
  const beside = [...gltf.refersTo.values()];
  if (missing.length > 0) {
    const message = `${name} is not whole: it refers to ${listed(missing)}, which ${missing.length === 1 ? 'is' : 'are'} missing.`;
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

/** glTF 2.0, §4.4.2. */
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
    // What is wrong with it is said where it is drawn.
    return null;
  }
}

function listed(names: readonly string[]): string {
  const quoted = names.map((name) => `“${name}”`);
  return [quoted.slice(0, -1).join(', '), quoted.at(-1)].filter(Boolean).join(' and ');
}
