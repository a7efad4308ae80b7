import { zlibSync } from 'fflate';
import { DataUtils } from 'three';
import { loadPanorama } from '../../export/runtime/scenes/environments/load-panorama.ts';
import { readRadianceInWorker } from '../../export/runtime/scenes/environments/read-radiance-in-worker.ts';
import { text } from '../../nodes/generated/workers/decode-radiance.gen.ts';

const WIDTH_PX = 8192;
const HEIGHT_PX = 4096;
/** Rows that ZIP compresses together. */
const ROWS = 16;
const ZIP = 3;
const BLOCKS = HEIGHT_PX / ROWS;
const LINE_BYTES = WIDTH_PX * 3 * 2;
/** A lamp in this row and column, of this radiance. */
const LAMP = { row: 1000, column: 6000, radiance: 40 } as const;

/** A black panorama with a lamp of one pixel, as OpenEXR with ZIP. */
export function largeExr(): ArrayBuffer {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const bytes: number[] = [];
  const int = (value: number): unknown => bytes.push(value & 255, (value >> 8) & 255, (value >> 16) & 255, (value >> 24) & 255);
  const name = (value: string): unknown => bytes.push(...new TextEncoder().encode(value), 0);
  const attribute = (key: string, type: string, values: readonly number[], isInts = false): void => {
    name(key);
    name(type);
    int(values.length * (isInts ? 4 : 1));
    for (const value of values) isInts ? int(value) : bytes.push(value);
  };
  const channels = ['B', 'G', 'R'].flatMap((one) => [one.charCodeAt(0), 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]);
  int(20000630);
  int(2);
  attribute('channels', 'chlist', [...channels, 0]);
  attribute('compression', 'compression', [ZIP]);
  attribute('dataWindow', 'box2i', [0, 0, WIDTH_PX - 1, HEIGHT_PX - 1], true);
  attribute('displayWindow', 'box2i', [0, 0, WIDTH_PX - 1, HEIGHT_PX - 1], true);
  attribute('lineOrder', 'lineOrder', [0]);
  attribute('pixelAspectRatio', 'float', [0, 0, 128, 63]);
  attribute('screenWindowCenter', 'v2f', new Array(8).fill(0));
  attribute('screenWindowWidth', 'float', [0, 0, 128, 63]);
  bytes.push(0);
  // Each byte is stored as its difference to the byte before, plus 128.
  const black = zlibSync(new Uint8Array(LINE_BYTES * ROWS).fill(128, 1)) as Uint8Array<ArrayBuffer>;
  // Blocks that compression would not make smaller are stored as they are.
  const plain = new Uint8Array(LINE_BYTES * ROWS);
  const half = DataUtils.toHalfFloat(LAMP.radiance);
  for (let channel = 0; channel < 3; channel++) {
    plain.set([half & 255, half >> 8], (LAMP.row % ROWS) * LINE_BYTES + (channel * WIDTH_PX + LAMP.column) * 2);
  }
  const blockOf = (block: number): Uint8Array<ArrayBuffer> => (block === Math.floor(LAMP.row / ROWS) ? plain : black);
  let at = bytes.length + BLOCKS * 8;
  for (let block = 0; block < BLOCKS; block++) {
    int(at);
    int(0);
    at += 8 + blockOf(block).length;
  }
  parts.push(new Uint8Array(bytes));
  for (let block = 0; block < BLOCKS; block++) {
    parts.push(new Uint8Array(Int32Array.of(block * ROWS, blockOf(block).length).buffer), blockOf(block));
  }
  const file = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let end = 0;
  for (const part of parts) {
    file.set(part, end);
    end += part.length;
  }
  return file.buffer;
}

/** Decodes it as a page does. `frames`: how many the page could draw meanwhile. */
export async function decode() {
  const bytes = largeExr();
  let frames = 0;
  let goesOn = true;
  const count = (): void => {
    frames++;
    if (goesOn) requestAnimationFrame(count);
  };
  requestAnimationFrame(count);
  const startMs = performance.now();
  const { texture, widthPx, heightPx, readPixels } = await loadPanorama(bytes, WIDTH_PX, readRadianceInWorker(text));
  const [ms, drawn] = [performance.now() - startMs, frames];
  const pixels = await readPixels();
  goesOn = false;
  const halves = (texture.image as { data: Uint16Array }).data;
  const row = (heightOf: boolean): number => (heightOf ? heightPx - 1 - LAMP.row : LAMP.row);
  const at = (fromBottom: boolean): number => (row(fromBottom) * widthPx + LAMP.column) * 4;
  return {
    size: [widthPx, heightPx],
    lamp: DataUtils.fromHalfFloat(halves[at(!texture.flipY)] ?? 0),
    lampForSearch: pixels.data[at(pixels.fromBottom === true)],
    bright: halves.reduce((sum, value, i) => sum + (i % 4 === 0 && value > 0 ? 1 : 0), 0),
    ms,
    drawn,
    all: frames,
  };
}

/** The same file, cut off. */
export async function decodeCut(): Promise<string> {
  const bytes = largeExr();
  return loadPanorama(bytes.slice(0, bytes.byteLength / 2), WIDTH_PX, readRadianceInWorker(text)).then(
    () => 'taken',
    (error: Error) => error.message,
  );
}
