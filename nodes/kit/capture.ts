/**
 * The format of a capture: photographs with their cameras, and the mesh of what they show (docs/CAPTURE-FORMAT.md). The camera is that of
 * Dupont de Dinechin and Paljic, “From Real to Virtual” (WEVR 2020), for perspective photographs: resolution, field of view, pose.
 */
export interface CaptureDocument {
  readonly format: 'scrim-capture';
  /** Version 2 has depth maps or depth meshes; version 3 has hidden meshes; version 4 has photographs in AVIF. */
  readonly version: (typeof VERSIONS)[number];
  readonly mesh: CaptureMeshFile;
  readonly views: readonly CaptureView[];
  /** A coarse form of the mesh, which pages draw until the other files are there. Exports make it; projects do not contain it. */
  readonly coarseMesh?: CaptureMeshFile;
  /** The most bytes that pages use on the GPU of a phone or headset. Exports set it; projects do not contain it. */
  readonly phoneGpuBytes?: number;
}

/** The file of the mesh: positions as 32-bit floats in meters, then the corners of triangles as 32-bit indices, little-endian. */
export interface CaptureMeshFile {
  /** Path relative to the folder of the document. */
  readonly file: string;
  readonly vertexCount: number;
  readonly triangleCount: number;
}

/**
 * The mesh of what one photograph shows: 8 bytes per vertex, then the corners of triangles as 32-bit indices, little-endian. A vertex is its
 * column and row in half pixels of a map of `widthPx` by `heightPx` as 16-bit whole numbers, then its depth in meters as a 32-bit float.
 */
export interface CaptureDepthMeshFile extends CaptureMeshFile {
  readonly widthPx: number;
  readonly heightPx: number;
}

/**
 * A pinhole camera. A pixel is a square; (0, 0) is the outer corner of the top left one, y down. With `projection`, it is a 360° camera: the
 * picture is twice as wide as high, its center is straight ahead, and it has pixels per radian in the place of focal lengths.
 */
export interface Pinhole {
  readonly projection?: 'equirectangular';
  readonly widthPx: number;
  readonly heightPx: number;
  readonly fxPx: number;
  readonly fyPx: number;
  readonly cxPx: number;
  readonly cyPx: number;
}

/** A photograph without distortion, and its camera. */
export interface CaptureView extends Pinhole {
  /** Path relative to the folder of the document. */
  readonly file: string;
  /** Column-major 4×4, rigid; the camera has y up and looks along −z. Meters. */
  readonly worldFromCamera: readonly number[];
  /** The path of a reduced form of the photograph, which pages draw until `file` is there. Exports make it. */
  readonly reducedFile?: string;
  readonly depth?: CaptureDepthFile;
  readonly depthMesh?: CaptureDepthMeshFile;
  /**
   * What the photograph does not show: the surface behind its near things. As `depthMesh`, and the colors of the vertices follow: RGBA, 8 bits.
   */
  readonly hiddenMesh?: CaptureDepthMeshFile;
}

/**
 * The depth that the camera of a view sees: a PNG file of 16 bits in gray, of the view's shape. A level of 0 is unknown. Pages do not contain
 * it.
 */
export interface CaptureDepthFile {
  /** Path relative to the folder of the document. */
  readonly file: string;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Depth along the axis of the camera that one level stands for, meters. */
  readonly metersPerLevel: number;
}

/** The mesh of a capture. */
export interface CaptureMesh {
  /** x, y, z of each vertex; meters. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** Three vertices per triangle. */
  readonly indices: Uint32Array<ArrayBuffer>;
}

const VERSIONS = [1, 2, 3, 4] as const;

/** The largest capture that is imported and shown. */
export const CAPTURE_LIMITS = { views: 1000, triangles: 4_000_000, vertices: 8_000_000, sidePx: 8192 } as const;

/** The most triangles of the depth meshes of a capture together. */
export const MOST_DEPTH_TRIANGLES = 8_000_000;

/** The name of the document in the folder of a capture. */
export const CAPTURE_FILE = 'capture.json';

/** A problem of a capture. The message is the end of a sentence for users, without its full stop. */
export class CaptureError extends Error {
  override readonly name = 'CaptureError';
}

/**
 * Reads and checks `capture.json`.
 *
 * @param text The file.
 * @throws CaptureError if the text is no capture of this version.
 *
 * @example
 * const { views } = readCapture(await file.text());
 */
export function readCapture(text: string): CaptureDocument {
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    throw new CaptureError('it is not valid JSON');
  }
  const { format, version, mesh, views, coarseMesh, phoneGpuBytes } = record(json, 'the document');
  if (format !== 'scrim-capture') throw new CaptureError('it is not a capture: its "format" is not "scrim-capture"');
  const known = VERSIONS.find((one) => one === version);
  if (!known) throw new CaptureError(`it has version ${String(version)}, but only versions 1 to 4 can be read`);
  if (!Array.isArray(views) || views.length === 0) throw new CaptureError('it has no views');
  if (views.length > CAPTURE_LIMITS.views) throw new CaptureError(`it has ${views.length} views, more than ${CAPTURE_LIMITS.views}`);
  const checked = views.map((view, i) => readView(view, `view ${i + 1}`));
  const names = new Set<string>();
  for (const file of checked.flatMap((view) => [
    view.file,
    ...[view.depth, view.depthMesh, view.hiddenMesh].flatMap((more) => more?.file ?? []),
  ])) {
    if (names.has(file)) throw new CaptureError(`two views have the file "${file}"`);
    names.add(file);
  }
  const depthTriangles = checked
    .flatMap(({ depthMesh, hiddenMesh }) => [depthMesh, hiddenMesh])
    .reduce((sum, mesh) => sum + (mesh?.triangleCount ?? 0), 0);
  if (depthTriangles > MOST_DEPTH_TRIANGLES) {
    throw new CaptureError(`its depth meshes have ${depthTriangles} triangles, more than ${MOST_DEPTH_TRIANGLES}`);
  }
  return {
    format,
    version: known,
    mesh: readMeshFile(mesh, 'the mesh'),
    views: checked,
    ...(coarseMesh === undefined ? {} : { coarseMesh: readMeshFile(coarseMesh, 'the coarse mesh') }),
    ...(phoneGpuBytes === undefined ? {} : { phoneGpuBytes: number(phoneGpuBytes, 'the memory on phones', true) }),
  };
}

/**
 * Reads and checks the mesh of a capture.
 *
 * @throws CaptureError if the bytes are not the mesh that the document describes.
 *
 * @example
 * const { positions, indices } = readCaptureMesh(document.mesh, bytes);
 */
export function readCaptureMesh({ vertexCount, triangleCount }: CaptureMeshFile, bytes: ArrayBuffer): CaptureMesh {
  const positionBytes = 12 * vertexCount;
  if (bytes.byteLength !== positionBytes + 12 * triangleCount) {
    throw new CaptureError(`its mesh has ${bytes.byteLength} bytes instead of ${positionBytes + 12 * triangleCount}`);
  }
  const positions = new Float32Array(bytes, 0, 3 * vertexCount);
  const indices = new Uint32Array(bytes, positionBytes, 3 * triangleCount);
  checkMesh({ positions, indices });
  return { positions, indices };
}

/**
 * Writes a mesh as the file that `readCaptureMesh` reads.
 *
 * @example
 * const bytes = captureMeshFile(mesh);
 */
export function captureMeshFile({ positions, indices }: CaptureMesh): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(positions.byteLength + indices.byteLength);
  bytes.set(new Uint8Array(positions.buffer, positions.byteOffset, positions.byteLength));
  bytes.set(new Uint8Array(indices.buffer, indices.byteOffset, indices.byteLength), positions.byteLength);
  return bytes;
}

/**
 * The counts of a mesh that the document of a capture contains.
 *
 * @example
 * const document = { ...rest, mesh: { file: 'mesh.bin', ...meshCounts(mesh) } };
 */
export function meshCounts({ positions, indices }: CaptureMesh): Omit<CaptureMeshFile, 'file'> {
  return { vertexCount: positions.length / 3, triangleCount: indices.length / 3 };
}

/**
 * Checks that all positions are finite, and that all corners are vertices.
 *
 * @throws CaptureError
 *
 * @example
 * checkMesh({ positions, indices });
 */
export function checkMesh({ positions, indices }: CaptureMesh): void {
  if (!positions.every(Number.isFinite)) throw new CaptureError('a vertex of its mesh is not finite');
  const count = positions.length / 3;
  if (!indices.every((index) => index < count)) throw new CaptureError(`a triangle of its mesh has a vertex beyond the ${count}`);
}

/**
 * Whether a path stays inside its folder: names separated by `/`, none of them `..`.
 *
 * @example
 * isInside('../secret.jpg'); // false
 */
export function isInside(path: string): boolean {
  return path.length <= 512 && path.split('/').every((part) => part !== '' && part !== '.' && part !== '..' && !/[\\:\0]/.test(part));
}

/** Largest difference of the axes of a pose from orthogonal unit vectors. */
const RIGID_TOLERANCE = 1e-3;

/**
 * What keeps a matrix from being a rigid transform, or null: `not finite`, `not rigid` (scaled or sheared) or `mirrored`.
 *
 * @param m Column-major 4×4.
 *
 * @example
 * poseFault(view.worldFromCamera); // null
 */
export function poseFault(m: readonly number[]): 'not finite' | 'not rigid' | 'mirrored' | null {
  if (m.length !== 16 || !m.every(Number.isFinite)) return 'not finite';
  const at = (row: number, column: number): number => m[4 * column + row] ?? 0;
  if ([0, 1, 2, 3].some((column) => at(3, column) !== (column === 3 ? 1 : 0))) return 'not rigid';
  const dot = (a: number, b: number): number => at(0, a) * at(0, b) + at(1, a) * at(1, b) + at(2, a) * at(2, b);
  for (let a = 0; a < 3; a++) {
    for (let b = a; b < 3; b++) if (Math.abs(dot(a, b) - (a === b ? 1 : 0)) > RIGID_TOLERANCE) return 'not rigid';
  }
  const determinant =
    at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
    at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
    at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
  return determinant < 0 ? 'mirrored' : null;
}

function readView(value: unknown, where: string): CaptureView {
  const view = record(value, where);
  const pose = view.worldFromCamera;
  if (!Array.isArray(pose) || !pose.every((x) => typeof x === 'number')) throw new CaptureError(`${where} has no pose of 16 numbers`);
  const fault = poseFault(pose);
  if (fault !== null) throw new CaptureError(`the pose of ${where} is ${fault}`);
  if (view.projection !== undefined && view.projection !== 'equirectangular') {
    throw new CaptureError(`the projection of ${where} is not known`);
  }
  return {
    file: path(view.file, where),
    ...(view.projection === undefined ? {} : { projection: view.projection }),
    widthPx: size(view.widthPx, `the width of ${where}`),
    heightPx: size(view.heightPx, `the height of ${where}`),
    fxPx: number(view.fxPx, `the focal length of ${where}`, true),
    fyPx: number(view.fyPx, `the focal length of ${where}`, true),
    cxPx: number(view.cxPx, `the center of ${where}`),
    cyPx: number(view.cyPx, `the center of ${where}`),
    worldFromCamera: pose,
    ...(view.reducedFile === undefined ? {} : { reducedFile: path(view.reducedFile, where) }),
    ...(view.depth === undefined ? {} : { depth: readDepthFile(view.depth, `the depth of ${where}`) }),
    ...(view.depthMesh === undefined ? {} : { depthMesh: readDepthMeshFile(view.depthMesh, `the depth mesh of ${where}`) }),
    ...(view.hiddenMesh === undefined ? {} : { hiddenMesh: readDepthMeshFile(view.hiddenMesh, `the hidden mesh of ${where}`) }),
  };
}

function readDepthFile(value: unknown, where: string): CaptureDepthFile {
  const depth = record(value, where);
  return {
    file: path(depth.file, where),
    widthPx: size(depth.widthPx, `the width of ${where}`),
    heightPx: size(depth.heightPx, `the height of ${where}`),
    metersPerLevel: number(depth.metersPerLevel, `the unit of ${where}`, true),
  };
}

function readDepthMeshFile(value: unknown, where: string): CaptureDepthMeshFile {
  const mesh = record(value, where);
  return {
    ...readMeshFile(value, where),
    widthPx: size(mesh.widthPx, `the width of ${where}`),
    heightPx: size(mesh.heightPx, `the height of ${where}`),
  };
}

function readMeshFile(value: unknown, where: string): CaptureMeshFile {
  const mesh = record(value, where);
  return {
    file: path(mesh.file, where),
    vertexCount: count(mesh.vertexCount, 'vertices', CAPTURE_LIMITS.vertices),
    triangleCount: count(mesh.triangleCount, 'triangles', CAPTURE_LIMITS.triangles),
  };
}

function record(value: unknown, what: string): Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw new CaptureError(`${what} is not an object`);
  return value as Record<string, unknown>;
}

function path(value: unknown, where: string): string {
  if (typeof value !== 'string' || !isInside(value)) throw new CaptureError(`the file of ${where} is not a path inside the capture`);
  return value;
}

function number(value: unknown, what: string, isPositive = false): number {
  if (typeof value !== 'number' || !Number.isFinite(value)) throw new CaptureError(`${what} is not a finite number`);
  if (isPositive && value <= 0) throw new CaptureError(`${what} is not above 0`);
  return value;
}

function size(value: unknown, what: string): number {
  if (typeof value !== 'number' || !Number.isInteger(value) || value < 1 || value > CAPTURE_LIMITS.sidePx) {
    throw new CaptureError(`${what} is not a whole number from 1 to ${CAPTURE_LIMITS.sidePx}`);
  }
  return value;
}

function count(value: unknown, what: string, most: number): number {
  if (typeof value !== 'number' || !Number.isInteger(value) || value < 1) throw new CaptureError(`its mesh has no ${what}`);
  if (value > most) throw new CaptureError(`its mesh has ${value} ${what}, more than ${most}`);
  return value;
}
