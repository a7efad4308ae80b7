/** What Scrim needs to know of a glTF document before three parses it (Khronos glTF 2.0 specification, §3 and §4). */
export interface GltfDocument {
  readonly asset?: { readonly version?: string };
  readonly extensionsUsed?: readonly string[];
  readonly extensionsRequired?: readonly string[];
  readonly scenes?: readonly unknown[];
  readonly buffers?: readonly { readonly uri?: string; readonly byteLength?: number }[];
  readonly bufferViews?: readonly { readonly buffer: number; readonly byteOffset?: number; readonly byteLength: number }[];
  readonly images?: readonly { readonly uri?: string; readonly bufferView?: number; readonly mimeType?: string }[];
}

/** Says what is wrong with a model and what to do, going on after "cannot be decoded: ". */
export class ModelError extends Error {}

const GLB_MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;

/** Extensions that three's loader applies without a decoder of its own. Others may be used, but not required. */
const SUPPORTED = new Set([
  ...['KHR_lights_punctual', 'KHR_materials_anisotropy', 'KHR_materials_clearcoat', 'KHR_materials_diffuse_roughness'],
  ...['KHR_materials_dispersion', 'KHR_materials_emissive_strength', 'KHR_materials_ior', 'KHR_materials_iridescence'],
  ...['KHR_materials_sheen', 'KHR_materials_specular', 'KHR_materials_transmission', 'KHR_materials_unlit', 'KHR_materials_volume'],
  ...['KHR_mesh_quantization', 'KHR_texture_transform', 'EXT_materials_bump', 'EXT_mesh_gpu_instancing'],
  ...['EXT_texture_avif', 'EXT_texture_webp'],
]);

/** three's loader gives up on these even where the file could do without. */
const NEEDS_DECODER = new Set(['KHR_draco_mesh_compression']);

/**
 * Reads the JSON of a `.glb` or `.gltf` file and refuses what cannot be shown.
 *
 * @throws ModelError
 */
export function readGltf(bytes: ArrayBuffer): GltfDocument {
  const view = new DataView(bytes);
  const isBinary = bytes.byteLength >= 4 && view.getUint32(0, true) === GLB_MAGIC;
  const text = isBinary ? readJsonChunk(bytes, view) : decode(new Uint8Array(bytes));
  const document = parse(text, isBinary);
  checkVersion(document);
  checkExtensions(document);
  checkReferences(document, isBinary);
  if (!document.scenes?.length) throw new ModelError('it holds no scene, so there is nothing to show.');
  return document;
}

/** A GLB file: 12 bytes of header, then chunks of length, type and content (§4.4). */
function readJsonChunk(bytes: ArrayBuffer, view: DataView): string {
  if (bytes.byteLength < HEADER_BYTES + CHUNK_HEADER_BYTES) throw truncated(bytes.byteLength, HEADER_BYTES + CHUNK_HEADER_BYTES);
  const version = view.getUint32(4, true);
  if (version !== 2)
    throw new ModelError(`it is a GLB file of version ${version}, and only version 2 can be read. Export it again as glTF 2.0.`);
  const length = view.getUint32(8, true);
  if (bytes.byteLength < length) throw truncated(bytes.byteLength, length);
  for (let at = HEADER_BYTES; at < length; ) {
    if (at + CHUNK_HEADER_BYTES > length) throw damaged('a part of it ends in the middle');
    const chunkBytes = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    const start = at + CHUNK_HEADER_BYTES;
    if (start + chunkBytes > length) throw damaged('a part of it is longer than the file');
    if (at === HEADER_BYTES && type !== JSON_CHUNK) throw damaged('it does not begin with its description');
    if (type === JSON_CHUNK) return decode(new Uint8Array(bytes, start, chunkBytes));
    at = start + chunkBytes;
  }
  throw damaged('its description is missing');
}

function parse(text: string, isBinary: boolean): GltfDocument {
  try {
    const json: unknown = JSON.parse(text);
    if (typeof json === 'object' && json !== null && 'asset' in json) return json as GltfDocument;
  } catch {
    // Said below, in words for people who never saw a parser.
  }
  throw isBinary ? damaged('its description is not valid JSON') : new ModelError('it is neither a .glb nor a .gltf file.');
}

function checkVersion({ asset }: GltfDocument): void {
  const version = String(asset?.version ?? 'unknown');
  if (!version.startsWith('2.')) throw new ModelError(`it is glTF ${version}, and only glTF 2.0 can be read. Export it again as glTF 2.0.`);
}

function checkExtensions({ extensionsUsed = [], extensionsRequired = [] }: GltfDocument): void {
  const missing = new Set([
    ...extensionsRequired.filter((name) => !SUPPORTED.has(name)),
    ...extensionsUsed.filter((name) => NEEDS_DECODER.has(name)),
  ]);
  if (missing.size === 0) return;
  const names = [...missing].join(', ');
  throw new ModelError(`it needs ${names}, which Scrim cannot decode yet. Export it without compression, as a plain .glb.`);
}

/** Everything must be in the file: a project's assets are single files, and an exported page fetches nothing else. */
function checkReferences({ buffers = [], bufferViews = [], images = [] }: GltfDocument, isBinary: boolean): void {
  for (const { uri } of [...buffers, ...images]) {
    if (uri !== undefined && !uri.startsWith('data:')) {
      throw new ModelError(`it refers to another file, "${uri}". Export it as one .glb file with everything in it.`);
    }
  }
  buffers.forEach(({ uri }, i) => {
    if (uri === undefined && !(isBinary && i === 0)) throw damaged(`its buffer ${i} has no content`);
  });
  bufferViews.forEach(({ buffer, byteOffset = 0, byteLength }, i) => {
    const size = buffers[buffer]?.byteLength ?? 0;
    if (byteOffset + byteLength > size) throw damaged(`its part ${i} lies outside its buffer`);
  });
}

function decode(bytes: Uint8Array): string {
  return new TextDecoder().decode(bytes);
}

function truncated(actual: number, expected: number): ModelError {
  return new ModelError(`the file is cut off: it should have ${expected} bytes and has ${actual}. Copy or export it again.`);
}

export function damaged(what: string): ModelError {
  return new ModelError(`the file is damaged: ${what}. Export it again.`);
}
