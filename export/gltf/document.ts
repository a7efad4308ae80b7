/** The properties of a glTF document that Scrim reads (Khronos glTF 2.0 specification, §5). */
export interface GltfDocument {
  readonly asset?: { readonly version?: string; readonly copyright?: string };
  readonly extensionsUsed?: readonly string[];
  readonly extensionsRequired?: readonly string[];
  /** Index of the scene that is shown. Default: the first. */
  readonly scene?: number;
  readonly scenes?: readonly { readonly nodes?: readonly number[] }[];
  readonly nodes?: readonly GltfNode[];
  readonly meshes?: readonly GltfMesh[];
  readonly animations?: readonly GltfAnimation[];
  readonly skins?: readonly { readonly inverseBindMatrices?: number; readonly joints?: readonly number[] }[];
  readonly accessors?: readonly GltfAccessor[];
  readonly bufferViews?: readonly GltfBufferView[];
  readonly buffers?: readonly GltfBuffer[];
  readonly images?: readonly GltfImage[];
  readonly materials?: readonly { readonly extensions?: Readonly<Record<string, unknown>> }[];
}

export interface GltfAnimation {
  readonly name?: string;
  readonly samplers: readonly { readonly input: number; readonly output: number }[];
}

export interface GltfNode {
  readonly children?: readonly number[];
  readonly mesh?: number;
  readonly skin?: number;
  readonly matrix?: readonly number[];
  readonly translation?: readonly number[];
  readonly rotation?: readonly number[];
  readonly scale?: readonly number[];
}

export interface GltfMesh {
  readonly primitives: readonly GltfPrimitive[];
}

export interface GltfPrimitive {
  readonly attributes: Readonly<Record<string, number>>;
  readonly indices?: number;
  /** Default: 4, triangles. */
  readonly mode?: number;
  readonly targets?: readonly Readonly<Record<string, number>>[];
  readonly extensions?: Readonly<Record<string, unknown>>;
}

export interface GltfAccessor {
  readonly bufferView?: number;
  readonly byteOffset?: number;
  readonly componentType: number;
  readonly count: number;
  readonly type: string;
  /** Whether integers stand for fractions of their largest value. */
  readonly normalized?: boolean;
  /** Least and greatest value of each component. Positions have them. */
  readonly min?: readonly number[];
  readonly max?: readonly number[];
  readonly sparse?: unknown;
}

export interface GltfBufferView {
  readonly buffer: number;
  readonly byteOffset?: number;
  readonly byteLength: number;
  readonly byteStride?: number;
  readonly extensions?: Readonly<Record<string, unknown>>;
}

export interface GltfBuffer {
  readonly uri?: string;
  readonly byteLength?: number;
  readonly extensions?: Readonly<Record<string, unknown>>;
}

export interface GltfImage {
  readonly uri?: string;
  readonly bufferView?: number;
  readonly mimeType?: string;
}

/** A parsed file: its document, and the binary chunk of a GLB. */
export interface Gltf {
  readonly document: GltfDocument;
  /** Null for a `.gltf`. */
  readonly binary: Uint8Array | null;
}

/** A problem of a model. The message has the problem and its remedy and follows “cannot be decoded: ”. */
export class ModelError extends Error {}

export function damaged(what: string): ModelError {
  return new ModelError(`the file is damaged: ${what}. Export it again.`);
}

const COMPONENT_BYTES: Readonly<Record<number, number>> = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 };
const COMPONENTS: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 };

/** Bytes of one element without padding; null for invalid types. */
export function elementBytes({ componentType, type }: GltfAccessor): number | null {
  const bytes = COMPONENT_BYTES[componentType];
  const count = COMPONENTS[type];
  return bytes === undefined || count === undefined ? null : bytes * count;
}

/** Whether an extension compresses the buffer view, so that its length does not limit the content. */
export function isPacked(view: GltfBufferView): boolean {
  return view.extensions !== undefined && ('EXT_meshopt_compression' in view.extensions || 'KHR_meshopt_compression' in view.extensions);
}
