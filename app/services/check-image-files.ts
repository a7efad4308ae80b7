import type { FileHandle } from 'node:fs/promises';
import { checkImageFile, sizeFault } from '../../export/gltf/image-faults.ts';

/** Maximum size of an image file. Larger files are rejected, because no browser decodes them. */
const MAX_IMAGE_BYTES = 256 * 2 ** 20;
/** Number of bytes that are read from the start of an image: almost always all that says how large it is. */
const IMAGE_HEAD_BYTES = 2 ** 20;
/** Number of bytes that are read from the start of a panorama. Both formats store their size in the header. */
const PANORAMA_HEAD_BYTES = 64 * 2 ** 10;

const NO_SIZE = 'is broken: it does not say how large it is.';

/** Checks an image after its signature, of which little is read. Returns the predicate of a message; null if the file is valid. */
export async function imageFileFault(file: FileHandle, size: number): Promise<string | null> {
  if (size > MAX_IMAGE_BYTES) return `is a file of ${Math.round(size / 2 ** 20)} MB, which no browser decodes.`;
  const check = checkImageFile(await readHead(file, Math.min(size, IMAGE_HEAD_BYTES)), size);
  for (let step = check.next(); ; ) {
    if (step.done) return step.value;
    step = check.next(await readPart(file, ...step.value));
  }
}

/** Checks a Radiance file: the line with the resolution ends its header ("-Y 1024 +X 2048"). */
export async function radianceFault(file: FileHandle, size: number): Promise<string | null> {
  const head = (await readHead(file, Math.min(size, PANORAMA_HEAD_BYTES))).toString('latin1');
  const [line, y, x] = /\n[+-]Y (\d+) [+-]X (\d+)\n/.exec(head) ?? [];
  if (line === undefined) return NO_SIZE;
  return sizeFault([Number(x), Number(y)]) ?? (head.indexOf(line) + line.length >= size ? 'is incomplete: it has no pixels.' : null);
}

/** Checks an OpenEXR file: the attribute `dataWindow` is a box of four numbers (OpenEXR file layout, "Header"). */
export async function exrFault(file: FileHandle, size: number): Promise<string | null> {
  const head = await readHead(file, Math.min(size, PANORAMA_HEAD_BYTES));
  const name = 'dataWindow\0box2i\0';
  const at = head.indexOf(name, 0, 'latin1') + name.length + 4;
  if (at < name.length + 4 || at + 16 > head.length) return NO_SIZE;
  const [left, top, right, bottom] = [0, 4, 8, 12].map((offset) => head.readInt32LE(at + offset)) as [number, number, number, number];
  return sizeFault([right - left + 1, bottom - top + 1]);
}

function readHead(file: FileHandle, length: number): Promise<Buffer> {
  return readPart(file, 0, length);
}

async function readPart(file: FileHandle, at: number, length: number): Promise<Buffer> {
  const bytes = Buffer.alloc(length);
  const { bytesRead } = await file.read(bytes, 0, length, at);
  return bytes.subarray(0, bytesRead);
}
