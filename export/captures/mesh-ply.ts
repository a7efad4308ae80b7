import { CAPTURE_LIMITS, CaptureError, type CaptureMesh } from '../../nodes/kit/capture.ts';
import { createMeshBuilder, tooLarge } from './mesh-builder.ts';
import { linesOf } from './text-lines.ts';

interface Property {
  readonly name: string;
  readonly type: string;
  /** Type of the length of a list; null for one number. */
  readonly listed: string | null;
}

interface Element {
  readonly name: string;
  readonly count: number;
  readonly properties: readonly Property[];
}

const TYPES: Readonly<Record<string, string>> = {
  char: 'int8',
  uchar: 'uint8',
  short: 'int16',
  ushort: 'uint16',
  int: 'int32',
  uint: 'uint32',
  float: 'float32',
  double: 'float64',
};
const BYTES: Readonly<Record<string, number>> = { int8: 1, uint8: 1, int16: 2, uint16: 2, int32: 4, uint32: 4, float32: 4, float64: 8 };

/** Reads the mesh of a PLY file: ASCII, or binary of either byte order. @throws CaptureError */
export function readPly(bytes: Uint8Array): CaptureMesh {
  const { format, elements, start } = readHeader(bytes);
  const next = format === 'ascii' ? readWords(bytes, start) : readBinary(bytes, start, format === 'binary_little_endian');
  // Refused by the header, before millions of records are read.
  const most: Readonly<Record<string, number>> = { vertex: CAPTURE_LIMITS.vertices, face: CAPTURE_LIMITS.triangles };
  if (elements.some(({ name, count }) => count > (most[name] ?? Number.POSITIVE_INFINITY))) throw tooLarge();
  const builder = createMeshBuilder();
  for (const { name, count, properties } of elements) {
    const place = properties.map((property) => (name === 'vertex' ? ['x', 'y', 'z'].indexOf(property.name) : -1));
    const position = [0, 0, 0];
    for (let i = 0; i < count; i++) {
      properties.forEach(({ name: property, type, listed }, p) => {
        if (listed === null) {
          const value = next(type);
          const axis = place[p] ?? -1;
          if (axis >= 0) position[axis] = value;
          return;
        }
        const length = next(listed);
        if (!(length >= 0 && length <= 65_535)) throw new CaptureError('the PLY file is damaged');
        const corners = Array.from({ length }, () => next(type));
        if (name !== 'face' || !/^vertex_ind(ex|ices)$/.test(property)) return;
        if (!corners.every(Number.isInteger)) throw new CaptureError('the PLY file is damaged');
        builder.polygon(corners);
      });
      if (name === 'vertex') builder.vertex(position[0] ?? 0, position[1] ?? 0, position[2] ?? 0);
    }
  }
  return builder.build();
}

function readHeader(bytes: Uint8Array) {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 65_536));
  const end = /end_header\r?\n/.exec(head);
  if (!head.startsWith('ply') || !end) throw new CaptureError('the mesh is not a PLY file');
  const elements: { name: string; count: number; properties: Property[] }[] = [];
  let format = '';
  for (const line of head.slice(0, end.index).split(/\r?\n/)) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'format') format = rest[0] ?? '';
    if (word === 'element') elements.push({ name: rest[0] ?? '', count: Number(rest[1]), properties: [] });
    if (word !== 'property') continue;
    const isList = rest[0] === 'list';
    const name = rest.at(-1) ?? '';
    elements.at(-1)?.properties.push({ name, type: typeOf(rest.at(-2)), listed: isList ? typeOf(rest[1]) : null });
  }
  if (!['ascii', 'binary_little_endian', 'binary_big_endian'].includes(format))
    throw new CaptureError('the PLY file has an unknown format');
  if (!elements.every(({ count }) => Number.isInteger(count) && count >= 0)) throw new CaptureError('the PLY file is damaged');
  return { format, elements: elements satisfies Element[], start: end.index + end[0].length };
}

function typeOf(name = ''): string {
  const type = TYPES[name] ?? name;
  if (BYTES[type] === undefined) throw new CaptureError(`the PLY file has an unknown type ${name}`);
  return type;
}

function readBinary(bytes: Uint8Array, start: number, isLittle: boolean): (type: string) => number {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = start;
  return (type) => {
    const from = at;
    at += BYTES[type] ?? 0;
    if (at > bytes.length) throw new CaptureError('the PLY file is incomplete');
    switch (type) {
      case 'int8':
        return view.getInt8(from);
      case 'uint8':
        return view.getUint8(from);
      case 'int16':
        return view.getInt16(from, isLittle);
      case 'uint16':
        return view.getUint16(from, isLittle);
      case 'int32':
        return view.getInt32(from, isLittle);
      case 'uint32':
        return view.getUint32(from, isLittle);
      case 'float32':
        return view.getFloat32(from, isLittle);
      default:
        return view.getFloat64(from, isLittle);
    }
  };
}

function readWords(bytes: Uint8Array, start: number): () => number {
  const lines = linesOf(bytes, start);
  let words: readonly string[] = [];
  let at = 0;
  return () => {
    while (at === words.length) {
      const { done, value } = lines.next();
      if (done) throw new CaptureError('the PLY file is incomplete');
      words = value.split(/\s+/).filter((word) => word !== '');
      at = 0;
    }
    return Number(words[at++]);
  };
}
