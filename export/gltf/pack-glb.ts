import { damaged, type Gltf, type GltfBufferView, type GltfDocument, ModelError } from './document.ts';

/**
 * Paths of the files that a model refers to, in the folder that `path` is relative to: `assets/cup.gltf` with `textures/wood.png` gives
 * `assets/textures/wood.png`.
 *
 * @returns Reference in the document → path.
 * @throws ModelError for references outside: URLs, absolute paths, `..` beyond the top.
 */
export function externalFiles({ buffers = [], images = [] }: GltfDocument, path: string): ReadonlyMap<string, string> {
  const uris = [...buffers, ...images].flatMap(({ uri }) => (uri === undefined || uri.startsWith('data:') ? [] : [uri]));
  return new Map(uris.map((uri) => [uri, pathBeside(path, uri)]));
}

function pathBeside(path: string, uri: string): string {
  const outside = new ModelError(`it refers to "${uri}", which is not in the project. Export it as one .glb file.`);
  if (/^[a-z][a-z0-9+.-]*:|^[\\/]|[\\?#]/i.test(uri)) throw outside;
  const parts = path.split('/').slice(0, -1);
  for (const part of decodeParts(uri, outside)) {
    if (part === '.') continue;
    if (part !== '..') parts.push(part);
    else if (parts.pop() === undefined) throw outside;
  }
  return parts.join('/');
}

/** References are percent-encoded (§2.8); the decoded names are checked too. */
function decodeParts(uri: string, outside: ModelError): string[] {
  try {
    const parts = uri.split('/').map(decodeURIComponent);
    if (parts.every((part) => part !== '' && !/[\\/\0:]/.test(part))) return parts;
  } catch {
    // Reported below.
  }
  throw outside;
}

const CHUNK = { json: 0x4e4f534a, binary: 0x004e4942 } as const;

/**
 * Packs a model into one GLB (§4.4) with the contents of `data:` URLs and external files in its buffer. Nothing is decoded, so nothing is
 * lost.
 *
 * @param files Contents of `externalFiles`, by reference.
 */
export function packGlb({ document, binary }: Gltf, files: ReadonlyMap<string, Uint8Array>): Uint8Array<ArrayBuffer> {
  const parts: Uint8Array[] = [];
  let length = 0;
  const add = (bytes: Uint8Array): number => {
    const at = length;
    const padding = -bytes.length & 3;
    parts.push(bytes, new Uint8Array(padding));
    length += bytes.length + padding;
    return at;
  };
  const contentOf = (uri: string): { bytes: Uint8Array; type: string | undefined } => {
    if (uri.startsWith('data:')) return decodeDataUrl(uri);
    const bytes = files.get(uri);
    if (!bytes) throw new ModelError(`the file "${uri}" that it refers to is missing.`);
    return { bytes, type: undefined };
  };

  const { buffers = [], bufferViews = [], images = [] } = document;
  const starts = buffers.map(({ uri, byteLength = 0, extensions }, i) => {
    if (uri === undefined && extensions !== undefined && !(i === 0 && binary)) return null;
    const bytes = uri === undefined ? binary : contentOf(uri).bytes;
    if (!bytes || bytes.length < byteLength) throw damaged(`buffer ${i} is too short`);
    return add(bytes.subarray(0, byteLength));
  });
  const kept = buffers.flatMap((buffer, i) => (starts[i] === null ? [{ buffer, i }] : []));
  const newIndex = (i: number) => (starts[i] === null ? 1 + kept.findIndex((k) => k.i === i) : 0);
  const moved = <T extends { buffer: number; byteOffset?: number }>(part: T): T => ({
    ...part,
    buffer: newIndex(part.buffer),
    byteOffset: (part.byteOffset ?? 0) + (starts[part.buffer] ?? 0),
  });
  const views: GltfBufferView[] = bufferViews.map((view) => movedView(view, moved));
  const packedImages = images.map((image) => {
    if (image.uri === undefined) return image;
    const { uri, ...rest } = image;
    const { bytes, type } = contentOf(uri);
    views.push({ buffer: 0, byteOffset: add(bytes), byteLength: bytes.length });
    return { ...rest, bufferView: views.length - 1, mimeType: image.mimeType ?? type ?? imageType(bytes) };
  });
  const packed: GltfDocument = {
    ...document,
    ...(length > 0 || kept.length > 0 ? { buffers: [{ byteLength: length }, ...kept.map(({ buffer }) => buffer)] } : {}),
    ...(views.length > 0 ? { bufferViews: views } : {}),
    ...(images.length > 0 ? { images: packedImages } : {}),
  };
  return writeGlb(packed, parts, length);
}

/** Applies `moved` to a buffer view and to its meshopt extension, which refers to a second buffer with the compressed data. */
function movedView(view: GltfBufferView, moved: <T extends { buffer: number; byteOffset?: number }>(part: T) => T): GltfBufferView {
  const extensions = Object.entries(view.extensions ?? {}).map(([name, value]) => [
    name,
    typeof value === 'object' && value !== null && 'buffer' in value ? moved(value as { buffer: number; byteOffset?: number }) : value,
  ]);
  return { ...moved(view), ...(extensions.length > 0 ? { extensions: Object.fromEntries(extensions) } : {}) };
}

function imageType(bytes: Uint8Array): string {
  if (bytes[0] === 0x89) return 'image/png';
  if (bytes[0] === 0xff) return 'image/jpeg';
  return bytes[0] === 0xab ? 'image/ktx2' : 'image/webp';
}

function writeGlb(document: GltfDocument, parts: readonly Uint8Array[], length: number): Uint8Array<ArrayBuffer> {
  const json = new TextEncoder().encode(JSON.stringify(document));
  const jsonLength = (json.length + 3) & ~3;
  const out = new Uint8Array(12 + 8 + jsonLength + (length > 0 ? 8 + length : 0));
  const view = new DataView(out.buffer);
  view.setUint32(0, 0x46546c67, true);
  view.setUint32(4, 2, true);
  view.setUint32(8, out.length, true);
  view.setUint32(12, jsonLength, true);
  view.setUint32(16, CHUNK.json, true);
  out.fill(0x20, 20, 20 + jsonLength);
  out.set(json, 20);
  if (length === 0) return out;
  let at = 20 + jsonLength;
  view.setUint32(at, length, true);
  view.setUint32(at + 4, CHUNK.binary, true);
  at += 8;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

/** Decodes a `data:` URL: `data:TYPE;base64,…` or percent-encoded text (RFC 2397). */
function decodeDataUrl(url: string): { bytes: Uint8Array<ArrayBuffer>; type: string } {
  const comma = url.indexOf(',');
  const [type = '', ...options] = url.slice('data:'.length, comma).split(';');
  const content = url.slice(comma + 1);
  const binary = options.includes('base64') ? atob(content) : decodeURIComponent(content);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return { bytes, type };
}
