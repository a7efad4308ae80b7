/** A binary model of COLMAP: cameras in a row that see points of a wavy wall, 2 units away, whose normals are known. */
export interface ColmapModel {
  readonly cameras: Uint8Array;
  readonly images: Uint8Array;
  readonly points3D: Uint8Array;
}

export const WIDTH_PX = 640;
export const HEIGHT_PX = 480;
const FOCAL_PX = 500;

/** The wall: z of a place. */
export const wallZ = (x: number, y: number): number => 2 + 0.1 * Math.sin(3 * x) * Math.cos(2 * y);

/** @param side Points along each side. */
export function colmapModel(names: readonly string[], side = 12): ColmapModel {
  const cameras = record(1);
  cameras
    .u32(1)
    .i32(1)
    .u64(WIDTH_PX)
    .u64(HEIGHT_PX)
    .doubles(FOCAL_PX, FOCAL_PX, WIDTH_PX / 2, HEIGHT_PX / 2);
  const places = Array.from({ length: side * side }, (_, i) => {
    const [x, y] = [(i % side) / (side - 1) - 0.5, Math.floor(i / side) / (side - 1) - 0.5];
    return [x, y, wallZ(x, y)] as const;
  });
  const images = record(names.length);
  for (const [index, name] of names.entries()) {
    const shift = 0.2 * (index - (names.length - 1) / 2);
    images
      .u32(index + 1)
      .doubles(1, 0, 0, 0, -shift, 0, 0)
      .u32(1)
      .text(name)
      .u64(places.length);
    for (const [i, [x, y, z]] of places.entries()) {
      images.doubles(WIDTH_PX / 2 + (FOCAL_PX * (x - shift)) / z, HEIGHT_PX / 2 + (FOCAL_PX * y) / z).u64(i + 1);
    }
  }
  const points = record(places.length);
  for (const [i, place] of places.entries()) {
    points
      .u64(i + 1)
      .doubles(...place)
      .bytes(200, 180, 160)
      .doubles(0.1)
      .u64(names.length);
    for (const index of names.keys()) points.u32(index + 1).u32(i);
  }
  return { cameras: cameras.done(), images: images.done(), points3D: points.done() };
}

function record(count: number) {
  const parts: Buffer[] = [];
  const add = (length: number, write: (buffer: Buffer) => void) => {
    const buffer = Buffer.alloc(length);
    write(buffer);
    parts.push(buffer);
    return self;
  };
  const self = {
    u32: (value: number) => add(4, (buffer) => buffer.writeUInt32LE(value)),
    i32: (value: number) => add(4, (buffer) => buffer.writeInt32LE(value)),
    u64: (value: number) => add(8, (buffer) => buffer.writeBigUInt64LE(BigInt(value))),
    doubles: (...values: readonly number[]) =>
      add(8 * values.length, (buffer) => values.forEach((value, i) => void buffer.writeDoubleLE(value, 8 * i))),
    bytes: (...values: readonly number[]) => add(values.length, (buffer) => buffer.set(values)),
    text: (text: string) => add(Buffer.byteLength(text) + 1, (buffer) => void buffer.write(text)),
    done: (): Uint8Array => Buffer.concat(parts),
  };
  self.u64(count);
  return self;
}
