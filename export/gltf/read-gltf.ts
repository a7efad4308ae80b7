import { checkAccessors } from './check-accessors.ts';
import { checkPacked } from './check-packed.ts';
import { isDecoded } from './decoders.ts';
import { damaged, type Gltf, type GltfDocument, ModelError } from './document.ts';
import { checkImages } from './image-faults.ts';

const GLB_MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;
const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;

/** Extensions that the loader of three.js supports. Others may be used, but not required. */
const SUPPORTED = new Set([
  ...['KHR_lights_punctual', 'KHR_materials_anisotropy', 'KHR_materials_clearcoat', 'KHR_materials_diffuse_roughness'],
  ...['KHR_materials_dispersion', 'KHR_materials_emissive_strength', 'KHR_materials_ior', 'KHR_materials_iridescence'],
  ...['KHR_materials_sheen', 'KHR_materials_specular', 'KHR_materials_transmission', 'KHR_materials_unlit', 'KHR_materials_volume'],
  ...['KHR_mesh_quantization', 'KHR_texture_transform', 'EXT_materials_bump', 'EXT_mesh_gpu_instancing'],
  ...['EXT_texture_avif', 'EXT_texture_webp'],
]);

/**
 * Reads and checks a `.glb` or `.gltf` file without decoding its data. The caller loads external files (`externalFiles`).
 *
 * @throws ModelError if the file is invalid or cannot be shown.
 */
export function readGltf(bytes: Uint8Array): Gltf {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const isBinary = bytes.length >= 4 && view.getUint32(0, true) === GLB_MAGIC;
  const chunks = isBinary ? readChunks(bytes, view) : null;
  const document = parse(decode(chunks?.json ?? bytes), isBinary);
  checkVersion(document);
  checkExtensions(document);
  checkBuffers(document, isBinary ? (chunks?.binary?.length ?? 0) : null);
  checkAccessors(document);
  checkSceneGraph(document);
  if (!document.scenes?.length) throw new ModelError('it contains no scene. Export it with a scene.');
  const gltf = { document, binary: chunks?.binary ?? null };
  checkPacked(gltf);
  checkImages(gltf);
  return gltf;
}

interface Chunks {
  readonly json: Uint8Array;
  readonly binary: Uint8Array | null;
}

/** A GLB file: a header of 12 bytes, then chunks with length, type and content (§4.4). */
function readChunks(bytes: Uint8Array, view: DataView): Chunks {
  if (bytes.length < HEADER_BYTES + CHUNK_HEADER_BYTES) throw truncated(bytes.length, HEADER_BYTES + CHUNK_HEADER_BYTES);
  const version = view.getUint32(4, true);
  if (version !== 2)
    throw new ModelError(`it is a GLB file of version ${version}, but only version 2 is supported. Export it again as glTF 2.0.`);
  const length = view.getUint32(8, true);
  if (bytes.length < length) throw truncated(bytes.length, length);
  let json: Uint8Array | null = null;
  let binary: Uint8Array | null = null;
  for (let at = HEADER_BYTES; at < length; ) {
    if (at + CHUNK_HEADER_BYTES > length) throw damaged('a chunk is incomplete');
    const chunkBytes = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    const start = at + CHUNK_HEADER_BYTES;
    if (start + chunkBytes > length) throw damaged('a chunk is longer than the file');
    if (json === null && type !== JSON_CHUNK) throw damaged('the first chunk is not JSON');
    const chunk = bytes.subarray(start, start + chunkBytes);
    if (type === JSON_CHUNK) json ??= chunk;
    else if (type === BINARY_CHUNK) binary ??= chunk;
    at = start + chunkBytes;
  }
  if (json === null) throw damaged('the JSON chunk is missing');
  return { json, binary };
}

function parse(text: string, isBinary: boolean): GltfDocument {
  try {
    const json: unknown = JSON.parse(text);
    if (typeof json === 'object' && json !== null && 'asset' in json) return json as GltfDocument;
  } catch {
    // Reported below.
  }
  throw isBinary ? damaged('its JSON is invalid') : new ModelError('it is neither a .glb nor a .gltf file.');
}

function checkVersion({ asset }: GltfDocument): void {
  const version = String(asset?.version ?? 'unknown');
  if (!version.startsWith('2.'))
    throw new ModelError(`it is glTF ${version}, but only glTF 2.0 is supported. Export it again as glTF 2.0.`);
}

function checkExtensions({ extensionsRequired = [] }: GltfDocument): void {
  const missing = extensionsRequired.filter((name) => !SUPPORTED.has(name) && !isDecoded(name));
  if (missing.length === 0) return;
  throw new ModelError(`it needs ${missing.join(', ')}, which Scrim cannot decode. Export it without them.`);
}

/** Rejects buffers without content and buffer views that exceed their buffer. `ownBytes` is the length of the binary chunk. */
function checkBuffers({ buffers = [], bufferViews = [] }: GltfDocument, ownBytes: number | null): void {
  buffers.forEach(({ uri, extensions }, i) => {
    // Fallback buffers of meshopt have no content (EXT_meshopt_compression, “Fallback buffers”).
    if (uri === undefined && extensions === undefined && !(ownBytes !== null && i === 0)) throw damaged(`buffer ${i} has no content`);
  });
  bufferViews.forEach(({ buffer, byteOffset = 0, byteLength }, i) => {
    const size = buffers[buffer]?.byteLength ?? 0;
    if (byteOffset + byteLength > size) throw damaged(`buffer view ${i} exceeds its buffer`);
  });
  const [own] = buffers;
  if (ownBytes === null || own === undefined || own.uri !== undefined || own.extensions !== undefined) return;
  if ((own.byteLength ?? 0) > ownBytes) throw damaged('buffer 0 is longer than the file');
}

function decode(bytes: Uint8Array): string {
  return new TextDecoder().decode(bytes);
}

function truncated(actual: number, expected: number): ModelError {
  return new ModelError(`the file is incomplete: it has ${actual} of ${expected} bytes. Copy or export it again.`);
}

/** Rejects nodes that refer to missing nodes or contain themselves, which three.js does not check (glTF 2.0, §3.5.2). */
function checkSceneGraph({ scenes = [], nodes = [], meshes = [] }: GltfDocument): void {
  if (scenes.some((scene) => scene.nodes?.some((index) => nodes[index] === undefined))) {
    throw damaged('the scene refers to a missing node');
  }
  const parents = new Array<number>(nodes.length).fill(0);
  nodes.forEach(({ children = [], mesh }, i) => {
    if (mesh !== undefined && meshes[mesh] === undefined) throw damaged(`node ${i} refers to a missing mesh`);
    for (const child of children) {
      if (nodes[child] === undefined) throw damaged(`node ${i} refers to a missing node`);
      parents[child] = (parents[child] ?? 0) + 1;
    }
  });
  // Removes nodes from the roots down; nodes that remain are on or below a cycle.
  const free = nodes.flatMap((_, i) => (parents[i] === 0 ? [i] : []));
  for (let taken = 0; taken < free.length; taken++) {
    for (const child of nodes[free[taken] ?? -1]?.children ?? []) {
      const left = (parents[child] ?? 0) - 1;
      parents[child] = left;
      if (left === 0) free.push(child);
    }
  }
  if (free.length < nodes.length) throw damaged(`node ${parents.findIndex((count) => count > 0)} contains itself`);
}
