import { damaged, type Gltf, isPacked } from './document.ts';
import { imageSize } from './image-size.ts';

/** Largest texture size of any WebGL device (`MAX_TEXTURE_SIZE` of desktop GPUs). */
export const MAX_IMAGE_SIDE_PX = 16_384;

/** What is wrong with an image file, as a clause that follows its name; null if nothing is found without decoding it. */
export function imageFault(bytes: Uint8Array): string | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  try {
    const size = sizeOf(bytes, view);
    if (size === null) return 'is damaged or has an unsupported format. Use PNG, JPEG or WebP.';
    return sizeFault(size) ?? (isCutOff(bytes, view) ? 'is incomplete.' : null);
  } catch (error) {
    // Read beyond the end.
    if (error instanceof RangeError) return 'is incomplete.';
    throw error;
  }
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

function isCutOff(bytes: Uint8Array, view: DataView): boolean {
  if (tag(bytes, 0) === '\x89PNG') return !hasPngEnd(bytes, view);
  if (view.getUint16(0) === 0xffd8) return !hasJpegEnd(bytes);
  if (tag(bytes, 0) === 'RIFF') return view.getUint32(4, true) + 8 > bytes.length;
  return tag(bytes, 4) === 'ftyp' && endsInBox(bytes, view);
}

/** Whether a file of boxes, such as AVIF, ends within one (ISO/IEC 14496-12 §4.2). A box of size 0 is the rest of the file. */
function endsInBox(bytes: Uint8Array, view: DataView): boolean {
  let at = 0;
  while (at + 8 <= bytes.length) {
    const size = view.getUint32(at);
    if (size === 0) return false;
    at += Math.max(8, size === 1 ? Number(view.getBigUint64(at + 8)) : size);
  }
  return at !== bytes.length;
}

/** Whether a PNG file is complete: its last chunk is IEND (PNG specification, §11.2.5). */
function hasPngEnd(bytes: Uint8Array, view: DataView): boolean {
  for (let at = 8; at + 12 <= bytes.length; at += 12 + view.getUint32(at)) if (tag(bytes, at + 4) === 'IEND') return true;
  return false;
}

/**
 * Whether a JPEG file is complete: it has an EOI marker (ITU T.81, §B.2.1). Cameras append data, and may embed a preview with its own EOI
 * before the frame.
 */
function hasJpegEnd(bytes: Uint8Array): boolean {
  for (let at = bytes.lastIndexOf(0xd9); at > 0; at = bytes.lastIndexOf(0xd9, at - 1)) {
    if (bytes[at - 1] === 0xff) return at > startOfScan(bytes);
  }
  return false;
}

function startOfScan(bytes: Uint8Array): number {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
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
