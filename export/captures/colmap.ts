import { CaptureError } from '../../nodes/kit/capture.ts';
import { type Lens, lensOf, modelOfId } from './lens.ts';
import { poseOfColmap, type SourceCapture, type SourceView } from './source-view.ts';
import { linesOf } from './text-lines.ts';

/** The files of a COLMAP model (colmap.github.io/format.html), as text or binary. Files of points may be missing. */
export interface ColmapFiles {
  readonly cameras: Uint8Array;
  readonly images: Uint8Array;
  readonly points: Uint8Array | null;
}

interface ColmapImage {
  readonly name: string;
  readonly camera: number;
  readonly pose: readonly number[];
  /** Column, row and id of the point, for each observation that has a point. */
  readonly seen: readonly number[];
}

/** A camera of a model. */
interface ColmapCamera {
  readonly model: string;
  readonly lens: Lens;
}

/** Reads a model of text files. @throws CaptureError */
export function readColmapText({ cameras, images, points }: ColmapFiles): SourceCapture {
  const cameraOf = new Map<number, ColmapCamera>();
  for (const { fields, line } of fieldsOf(cameras)) {
    if (fields.length === 0) continue;
    const [id, model = '', width, height, ...params] = fields;
    const numbers = [id, width, height, ...params].map(Number);
    if (!numbers.every(Number.isFinite)) throw new CaptureError(`line ${line} of cameras.txt has a number that is not finite`);
    const [key = 0, widthPx = 0, heightPx = 0, ...rest] = numbers;
    cameraOf.set(key, { model, lens: lensOf(model, widthPx, heightPx, rest) });
  }
  const positions = new Map<number, readonly number[]>();
  for (const { fields, line } of points === null ? [] : fieldsOf(points)) {
    if (fields.length === 0) continue;
    const [id = 0, ...position] = fields.slice(0, 4).map(Number);
    if (position.length < 3 || !position.every(Number.isFinite)) {
      throw new CaptureError(`line ${line} of points3D.txt has a number that is not finite`);
    }
    positions.set(id, position);
  }
  return finish('COLMAP (text)', cameraOf, readImagesText(images), positions);
}

function readImagesText(bytes: Uint8Array): ColmapImage[] {
  const found: ColmapImage[] = [];
  const lines = fieldsOf(bytes);
  for (const { fields, line, text } of lines) {
    if (fields.length === 0) continue;
    const numbers = fields.slice(1, 9).map(Number);
    if (numbers.length < 8 || fields.length < 10) throw new CaptureError(`line ${line} of images.txt is not an image`);
    // The name may contain spaces.
    const name = /^(?:\S+\s+){9}(.*?)\s*$/.exec(text.trimStart())?.[1] ?? '';
    const seen: number[] = [];
    const { value } = lines.next();
    const observed = (value?.fields ?? []).map(Number);
    if (observed.length % 3 !== 0 || !observed.every(Number.isFinite)) {
      throw new CaptureError(`line ${value?.line} of images.txt does not have the points of ${name}: it may be empty, but not missing`);
    }
    for (let j = 0; j + 2 < observed.length; j += 3) if ((observed[j + 2] ?? -1) >= 0) seen.push(...observed.slice(j, j + 3));
    found.push({ name, camera: numbers[7] ?? 0, pose: poseOfColmap(numbers.slice(0, 4), numbers.slice(4, 7), name), seen });
  }
  return found;
}

interface Line {
  readonly text: string;
  readonly fields: readonly string[];
  /** From 1. */
  readonly line: number;
}

/** The lines of a file without comments. */
function* fieldsOf(bytes: Uint8Array): Generator<Line, undefined> {
  let line = 0;
  for (const text of linesOf(bytes)) {
    line++;
    if (!text.startsWith('#')) yield { text, fields: text.split(/\s+/).filter((word) => word !== ''), line };
  }
}

/** Reads a model of binary files. @throws CaptureError */
export function readColmapBinary({ cameras, images, points }: ColmapFiles): SourceCapture {
  const cameraOf = new Map<number, ColmapCamera>();
  const camera = createReader(cameras, 'cameras.bin');
  for (let left = camera.count(24); left > 0; left--) {
    const id = camera.uint32();
    const model = modelOfId(camera.uint32());
    const widthPx = camera.uint64();
    const heightPx = camera.uint64();
    cameraOf.set(id, { model: model.name, lens: lensOf(model.name, widthPx, heightPx, camera.doubles(model.params)) });
  }
  const positions = new Map<number, readonly number[]>();
  if (points !== null) {
    const point = createReader(points, 'points3D.bin');
    for (let left = point.count(43); left > 0; left--) {
      const id = point.uint64();
      const position = point.doubles(3);
      if (!position.every(Number.isFinite)) throw new CaptureError('a point of points3D.bin is not finite');
      positions.set(id, position);
      point.skip(11);
      point.skip(8 * point.count(8));
    }
  }
  return finish('COLMAP (binary)', cameraOf, readImagesBinary(images), positions);
}

function readImagesBinary(bytes: Uint8Array): ColmapImage[] {
  const image = createReader(bytes, 'images.bin');
  const found: ColmapImage[] = [];
  for (let left = image.count(73); left > 0; left--) {
    image.uint32();
    const rotation = image.doubles(4);
    const translation = image.doubles(3);
    const camera = image.uint32();
    const name = image.text();
    const seen: number[] = [];
    for (let observations = image.count(24); observations > 0; observations--) {
      const [column = 0, row = 0] = image.doubles(2);
      const point = image.int64();
      if (point >= 0) seen.push(column, row, point);
    }
    found.push({ name, camera, pose: poseOfColmap(rotation, translation, name), seen });
  }
  return found;
}

/** Reads little-endian records. Throws if the file ends early. */
function createReader(bytes: Uint8Array, file: string) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 0;
  const take = (length: number): number => {
    if (length > bytes.length - at) throw new CaptureError(`${file} is incomplete`);
    at += length;
    return at - length;
  };
  const uint64 = (): number => Number(view.getBigUint64(take(8), true));
  return {
    uint32: () => view.getUint32(take(4), true),
    uint64,
    int64: () => Number(view.getBigInt64(take(8), true)),
    doubles: (count: number) => {
      const start = take(8 * count);
      return Array.from({ length: count }, (_, i) => view.getFloat64(start + 8 * i, true));
    },
    text: () => {
      const end = bytes.indexOf(0, at);
      if (end < 0) throw new CaptureError(`${file} is incomplete`);
      const start = take(end + 1 - at);
      return new TextDecoder().decode(bytes.subarray(start, end));
    },
    skip: (length: number) => void take(length),
    /** Number of records of at least so many bytes. */
    count: (recordBytes: number) => {
      const count = uint64();
      if (count * recordBytes > bytes.length - at) throw new CaptureError(`${file} is incomplete`);
      return count;
    },
  };
}

function finish(
  form: string,
  cameraOf: ReadonlyMap<number, ColmapCamera>,
  images: readonly ColmapImage[],
  positions: ReadonlyMap<number, readonly number[]>,
): SourceCapture {
  const views = images.map(({ name, camera, pose, seen }): SourceView => {
    const found = cameraOf.get(camera);
    if (!found) throw new CaptureError(`${name} has the camera ${camera}, which the reconstruction does not describe`);
    const observations: number[] = [];
    for (let i = 0; i + 2 < seen.length; i += 3) {
      const position = positions.get(seen[i + 2] ?? -1);
      if (position) observations.push(seen[i] ?? 0, seen[i + 1] ?? 0, ...position);
    }
    const { model, lens } = found;
    return {
      name,
      model,
      lens: () => lens,
      sizePx: [lens.widthPx, lens.heightPx],
      depthName: null,
      worldFromCamera: pose,
      observations: Float64Array.from(observations),
    };
  });
  return { form, views, pointCount: positions.size };
}
