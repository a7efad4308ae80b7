import { damaged, type Gltf, isPacked } from './document.ts';
import { imageSize } from './image-size.ts';

/** Largest texture size of any WebGL device (`MAX_TEXTURE_SIZE` of desktop GPUs). */
export const MAX_IMAGE_SIDE_PX = 16_384;

/** What is wrong with an image file, as a clause that follows its name; null if nothing is found without decoding it. */
export function imageFault(bytes: Uint8Array): string | null {
  const check = checkImageFile(bytes, bytes.length);
  let step = check.next();
  while (!step.done) {
    const [at, length] = step.value;
    step = check.next(bytes.subarray(at, at + length));
  }
  return step.value;
}

/** A check that asks for parts of a file, as place and length, and is given them. At the end of the file, a part is shorter. */
export type CheckByParts<T> = Generator<readonly [at: number, length: number], T, Uint8Array>;

/**
 * Checks an image file without all of it in memory.
 *
 * @param head The beginning of the file. If that does not say how large the image is, the whole file is asked for.
 * @param length The length of the file.
 * @returns As `imageFault`.
 */
export function* checkImageFile(head: Uint8Array, length: number): CheckByParts<string | null> {
  const view = viewOf(head);
  try {
    const size = sizeOf(head, view);
    if (size !== null) return sizeFault(size) ?? ((yield* isCutOff(head, view, length)) ? INCOMPLETE : null);
    if (head.length >= length) return UNSUPPORTED;
  } catch (error) {
    // Read beyond the end.
    if (!(error instanceof RangeError)) throw error;
    if (head.length >= length) return INCOMPLETE;
  }
  const whole = yield [0, length];
  return yield* checkImageFile(whole, whole.length);
}

const INCOMPLETE = 'is incomplete.';
const UNSUPPORTED = 'is damaged or has an unsupported format. Use PNG, JPEG or WebP.';

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

type Size = readonly [widthPx: number, heightPx: number];

/** What is wrong with the size of an image, as a clause; null if the size is supported. */
export function sizeFault([widthPx, heightPx]: Size): string | null {
  if (widthPx < 1 || heightPx < 1) return `has no pixels: it is ${widthPx} × ${heightPx}.`;
  if (Math.max(widthPx, heightPx) <= MAX_IMAGE_SIDE_PX) return null;
  return `is ${widthPx} × ${heightPx} pixels; the limit is ${MAX_IMAGE_SIDE_PX} in each direction.`;
}

function sizeOf(bytes: Uint8Array, view: DataView): Size | null {
  const size = imageSize(bytes);
  if (size !== null) return [size.widthPx, size.heightPx];
  switch (tag(bytes, 0)) {
    case 'GIF8':
      return [view.getUint16(6, true), view.getUint16(8, true)];
    case '\x89PNG':
      return null;
  }
  if (tag(bytes, 0, 2) === 'BM') return [view.getInt32(18, true), Math.abs(view.getInt32(22, true))];
  return tag(bytes, 4) === 'ftyp' ? avifSize(bytes, view) : null;
}

/**
 * Size of an AVIF image from its `ispe` boxes (ISO/IEC 23008-12 §6.5.3): the largest is that of the image, others are those of tiles and
 * thumbnails.
 */
function avifSize(bytes: Uint8Array, view: DataView): Size | null {
  let largest: Size | null = null;
  for (let at = bytes.indexOf(0x69); at >= 0 && at + 16 <= bytes.length; at = bytes.indexOf(0x69, at + 1)) {
    if (tag(bytes, at) !== 'ispe') continue;
    const size: Size = [view.getUint32(at + 8), view.getUint32(at + 12)];
    if (largest === null || size[0] * size[1] > largest[0] * largest[1]) largest = size;
  }
  return largest;
}

function* isCutOff(head: Uint8Array, view: DataView, length: number): CheckByParts<boolean> {
  if (tag(head, 0) === '\x89PNG') return !(yield* hasPngEnd(length));
  if (view.getUint16(0) === 0xffd8) return !(yield* hasJpegEnd(head, length));
  if (tag(head, 0) === 'RIFF') return view.getUint32(4, true) + 8 > length;
  return tag(head, 4) === 'ftyp' && (yield* endsInBox(length));
}

/** Whether a file of boxes, such as AVIF, ends within one (ISO/IEC 14496-12 §4.2). A box of size 0 is the rest of the file. */
function* endsInBox(length: number): CheckByParts<boolean> {
  let at = 0;
  while (at + 8 <= length) {
    const box = viewOf(yield [at, 16]);
    const size = box.getUint32(0);
    if (size === 0) return false;
    at += Math.max(8, size === 1 ? Number(box.getBigUint64(8)) : size);
  }
  return at !== length;
}

/** Whether a PNG file is complete: its last chunk is IEND (PNG specification, §11.2.5). */
function* hasPngEnd(length: number): CheckByParts<boolean> {
  for (let at = 8; at + 12 <= length; ) {
    const chunk = yield [at, 8];
    if (tag(chunk, 4) === 'IEND') return true;
    at += 12 + viewOf(chunk).getUint32(0);
  }
  return false;
}

/** The end of a JPEG file is sought in parts of this size. */
const TAIL_BYTES = 2 ** 20;

/**
 * Whether a JPEG file is complete: it has an EOI marker (ITU T.81, §B.2.1). Cameras append data, and may embed a preview with its own EOI
 * before the frame.
 */
function* hasJpegEnd(head: Uint8Array, length: number): CheckByParts<boolean> {
  const scan = startOfScan(head);
  for (let end = length; end > scan; end -= TAIL_BYTES) {
    const start = Math.max(0, end - TAIL_BYTES);
    // With the byte after it, which may be the second of a marker.
    const part = yield [start, Math.min(end + 1, length) - start];
    for (let at = part.lastIndexOf(0xd9); at > 0; at = part.lastIndexOf(0xd9, at - 1)) {
      if (part[at - 1] === 0xff) return start + at > scan;
    }
  }
  return false;
}

function startOfScan(bytes: Uint8Array): number {
  const view = viewOf(bytes);
  for (let at = 2; ; at += 2 + view.getUint16(at + 2)) if (view.getUint16(at) === 0xffda) return at;
}

function tag(bytes: Uint8Array, at: number, length = 4): string {
  return String.fromCharCode(...bytes.subarray(at, at + length));
}

/** Rejects embedded images that browsers cannot decode or show, because the whole model would then fail on the page. */
export function checkImages({ document, binary }: Gltf): void {
  const { images = [], bufferViews = [] } = document;
  if (binary === null) return;
  images.forEach(({ bufferView }, i) => {
    if (bufferView === undefined) return;
    const view = bufferViews[bufferView];
    if (!view) throw damaged(`image ${i} refers to a missing buffer view`);
    if (view.buffer !== 0 || isPacked(view)) return;
    const start = view.byteOffset ?? 0;
    const bytes = binary.subarray(start, start + view.byteLength);
    const fault = imageFault(bytes);
    if (fault !== null) throw damaged(`image ${i} ${fault.replace(/\.$/, '')}`);
  });
}
