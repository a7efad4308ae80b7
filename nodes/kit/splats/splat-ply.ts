import { packSplats, type Splat } from './splat-packer.ts';
import { COEFFICIENTS, checkCount, SplatError, type Splats } from './splats.ts';

/** What the header of a PLY file says of its splats. */
export interface SplatPlyHeader {
  readonly count: number;
  readonly degree: Splats['degree'];
  /** Where the first splat begins, bytes. */
  readonly start: number;
  /** Bytes per splat. */
  readonly stride: number;
  /** Where a property is in a splat, bytes. */
  readonly offsets: ReadonlyMap<string, number>;
}

/** The largest header that is read. That of a file with all harmonics has 1.5 KB. */
export const MAX_PLY_HEADER_BYTES = 65_536;

const BASE = ['x', 'y', 'z', 'f_dc_0', 'f_dc_1', 'f_dc_2', 'opacity', 'scale_0', 'scale_1', 'scale_2', 'rot_0', 'rot_1', 'rot_2', 'rot_3'];
const BYTES: Readonly<Record<string, number>> = {
  char: 1,
  int8: 1,
  uchar: 1,
  uint8: 1,
  short: 2,
  int16: 2,
  ushort: 2,
  uint16: 2,
  int: 4,
  int32: 4,
  uint: 4,
  uint32: 4,
  float: 4,
  float32: 4,
  double: 8,
  float64: 8,
};
const TRAIN = 'Choose the PLY file that the training of Gaussian splats wrote, often point_cloud.ply.';

/**
 * Reads and checks the header of a PLY file with Gaussian splats.
 *
 * @param bytes The file, or its first `MAX_PLY_HEADER_BYTES`.
 * @param fileBytes The size of the whole file.
 * @throws SplatError if it is not binary, has something else than splats, or is incomplete.
 *
 * @example
 * const { count, degree } = readSplatPlyHeader(bytes, bytes.length);
 */
export function readSplatPlyHeader(bytes: Uint8Array, fileBytes: number): SplatPlyHeader {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, MAX_PLY_HEADER_BYTES));
  const end = /^end_header\r?\n/m.exec(head);
  if (!/^ply\r?\n/.test(head)) throw new SplatError('it is not a PLY file');
  if (!end) throw new SplatError('its PLY header is incomplete');
  const { format, elements } = parse(head.slice(0, end.index));
  const vertices = elements.find(({ name }) => name === 'vertex');
  checkContent(elements, vertices);
  if (format !== 'binary_little_endian') {
    throw new SplatError(`it is a PLY file in the format ${format}`, 'Save it as binary, little endian.');
  }
  let start = end.index + end[0].length;
  for (const element of elements) {
    if (element === vertices) break;
    start += element.count * strideOf(element);
  }
  const stride = strideOf(vertices);
  const offsets = new Map<string, number>();
  let at = 0;
  for (const { name, type } of vertices.properties) {
    if (/^float(32)?$/.test(type)) offsets.set(name, at);
    at += BYTES[type] ?? 0;
  }
  const wrong = BASE.find((name) => !offsets.has(name));
  if (wrong !== undefined) throw new SplatError(`its property ${wrong} is not a 32-bit float`);
  checkCount(vertices.count);
  const present = Math.floor((fileBytes - start) / stride);
  if (present < vertices.count) throw new SplatError(`it is incomplete: it has ${Math.max(0, present)} of ${vertices.count} splats`);
  return { count: vertices.count, degree: degreeOf(offsets), start, stride, offsets };
}

/**
 * Reads the splats of a PLY file.
 *
 * @throws SplatError
 *
 * @example
 * const splats = readSplatPly(new Uint8Array(buffer));
 */
export function readSplatPly(bytes: Uint8Array): Splats {
  const { count, degree, start, stride, offsets } = readSplatPlyHeader(bytes, bytes.length);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const at = (name: string): number => offsets.get(name) ?? 0;
  const list = (prefix: string, names: readonly (number | string)[]): number[] => names.map((name) => at(`${prefix}${name}`));
  const positions = list('', ['x', 'y', 'z']);
  const scales = list('scale_', [0, 1, 2]);
  // The file has the real part first.
  const rotations = list('rot_', [1, 2, 3, 0]);
  const bases = list('f_dc_', [0, 1, 2]);
  const opacity = at('opacity');
  const coefficients = COEFFICIENTS[degree];
  // The file has all coefficients of red, then those of green and of blue.
  const rest = Array.from({ length: 3 * coefficients }, (_, i) => at(`f_rest_${(i % 3) * coefficients + Math.floor(i / 3)}`));
  return packSplats(count, degree, false, (index, splat: Splat) => {
    const from = start + index * stride;
    const read = (out: Float64Array, places: readonly number[]): void => {
      for (let i = 0; i < places.length; i++) out[i] = view.getFloat32(from + (places[i] as number), true);
    };
    read(splat.position, positions);
    read(splat.scale, scales);
    for (let axis = 0; axis < 3; axis++) splat.scale[axis] = Math.exp(splat.scale[axis] as number);
    read(splat.rotation, rotations);
    read(splat.base, bases);
    read(splat.harmonics, rest);
    splat.opacity = 1 / (1 + Math.exp(-view.getFloat32(from + opacity, true)));
  });
}

interface Property {
  readonly name: string;
  readonly type: string;
}

interface Element {
  readonly name: string;
  readonly count: number;
  readonly properties: Property[];
}

function parse(head: string): { readonly format: string; readonly elements: readonly Element[] } {
  const elements: Element[] = [];
  let format = '';
  for (const line of head.split(/\r?\n/)) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'format') format = rest[0] ?? '';
    if (word === 'element') elements.push({ name: rest[0] ?? '', count: Number(rest[1]), properties: [] });
    if (word === 'property') elements.at(-1)?.properties.push({ name: rest.at(-1) ?? '', type: rest[0] ?? '' });
  }
  return { format, elements };
}

/** Refuses what is often taken for splats, with what to do. */
function checkContent(elements: readonly Element[], vertices: Element | undefined): asserts vertices is Element {
  const properties = new Set(vertices?.properties.map(({ name }) => name));
  if (properties.has('packed_position')) {
    throw new SplatError('it is a compressed PLY file of SuperSplat', 'Export it from there as PLY or as SOG.');
  }
  const missing = BASE.filter((name) => !properties.has(name));
  if (missing.length === 0) return;
  const hasNone = !properties.has('f_dc_0') && !properties.has('rot_0');
  if (hasNone && elements.some(({ name, count }) => name === 'face' && count > 0)) {
    throw new SplatError('this PLY file holds a mesh, not splats', 'Save the mesh as .glb and import it as a model.');
  }
  if (hasNone) throw new SplatError('this PLY file holds points without size and rotation, not splats', TRAIN);
  throw new SplatError(`it lacks ${missing.join(', ')}`, TRAIN);
}

function strideOf({ name, properties }: Element): number {
  let bytes = 0;
  for (const { type } of properties) {
    const size = BYTES[type];
    if (size === undefined) throw new SplatError(`its element ${name} has a property of the type ${type}`);
    bytes += size;
  }
  return bytes;
}

/** The degree by the number of coefficients. */
function degreeOf(offsets: ReadonlyMap<string, number>): Splats['degree'] {
  let coefficients = 0;
  while (offsets.has(`f_rest_${coefficients}`)) coefficients++;
  const degree = ([0, 1, 2, 3] as const).find((each) => 3 * COEFFICIENTS[each] === coefficients);
  if (degree === undefined) throw new SplatError(`it has ${coefficients} coefficients of harmonics; splats have 0, 9, 24 or 45`);
  return degree;
}
