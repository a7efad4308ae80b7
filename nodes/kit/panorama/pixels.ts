import { linearFromSrgb } from '../color-math.ts';

/**
 * The pixels of an equirectangular panorama, rows from the top, with 1, 3 or 4 channels side by side; one is gray. Floats, and halves as
 * 16-bit integers, are linear-sRGB radiance. Bytes are display-referred sRGB, and 255 means that brightness or more.
 */
export interface PanoramaPixels {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly channels: 1 | 3 | 4;
  readonly data: Float32Array | Uint16Array | Uint8Array | Uint8ClampedArray;
  /** True if the first row of `data` is the lowest of the image. */
  readonly fromBottom?: boolean;
}

/** Number of rows that an analysis processes between two yields: about a millisecond of work with 1024 pixels per row. */
export const ROWS_PER_STEP = 32;

/**
 * Runs an analysis to its end, without pauses.
 *
 * @returns What the generator returns.
 * @example
 * const lamps = runWhole(findBySolidAngle(pixels, { lamps: 3, clippedShare: 0.5 }));
 */
export function runWhole<T>(slices: Generator<undefined, T>): T {
  for (;;) {
    const { done, value } = slices.next();
    if (done) return value;
  }
}

/** The largest half float; infinite radiance counts as this much. */
const MAX_RADIANCE = 65504;

/**
 * Whether the pixels are display-referred, so that bright lamps are clipped to white.
 *
 * @example
 * isDisplayReferred({ data: new Uint8Array(24), widthPx: 4, heightPx: 2, channels: 3 }); // true
 */
export function isDisplayReferred({ data }: PanoramaPixels): boolean {
  return data.BYTES_PER_ELEMENT === 1;
}

/**
 * Index in `data` of the first number of row `y`, counted from the top of the image.
 *
 * @example
 * startOfRow({ data: new Uint8Array(24), widthPx: 4, heightPx: 2, channels: 3 }, 1); // 12
 */
export function startOfRow({ widthPx, heightPx, channels, fromBottom = false }: PanoramaPixels, y: number): number {
  return (fromBottom ? heightPx - 1 - y : y) * widthPx * channels;
}

/** Reads rows as linear-sRGB radiance, three numbers per pixel. */
export interface RowReader {
  /**
   * The number of pixels read so far that have a channel that is not a number, infinite or negative. Such channels are read as 0, the
   * largest half float and 0.
   */
  readonly damaged: number;
  read(y: number, into: Float32Array): void;
}

/**
 * Creates a reader of linear rows. White of a display-referred panorama is 1.
 *
 * @example
 * const rows = createRowReader(pixels);
 * rows.read(0, row);
 */
export function createRowReader(pixels: PanoramaPixels): RowReader {
  const { data, widthPx, channels } = pixels;
  const table = data.BYTES_PER_ELEMENT === 1 ? linearTable() : data.BYTES_PER_ELEMENT === 2 ? halfTable() : null;
  // Offsets from red to green and blue.
  const [green, blue] = channels === 1 ? ([0, 0] as const) : ([1, 2] as const);
  // Of the current pixel.
  let whole = true;
  const sound = (value: number): number => {
    if (value >= 0 && value <= MAX_RADIANCE) return value;
    whole &&= value > 0 && value !== Number.POSITIVE_INFINITY;
    return value > 0 ? MAX_RADIANCE : 0;
  };
  const readBytes = (linear: Float32Array, y: number, into: Float32Array): void => {
    let from = startOfRow(pixels, y);
    for (let i = 0; i < widthPx * 3; i += 3, from += channels) {
      into[i] = linear[data[from] ?? 0] ?? 0;
      into[i + 1] = linear[data[from + green] ?? 0] ?? 0;
      into[i + 2] = linear[data[from + blue] ?? 0] ?? 0;
    }
  };
  const reader = {
    damaged: 0,
    read: (y: number, into: Float32Array): void => {
      if (table !== null && data.BYTES_PER_ELEMENT === 1) {
        readBytes(table, y, into);
        return;
      }
      let from = startOfRow(pixels, y);
      for (let i = 0; i < widthPx * 3; i += 3, from += channels) {
        const [r, g, b] = [data[from] ?? 0, data[from + green] ?? 0, data[from + blue] ?? 0];
        whole = true;
        into[i] = sound(table === null ? r : (table[r] ?? 0));
        into[i + 1] = sound(table === null ? g : (table[g] ?? 0));
        into[i + 2] = sound(table === null ? b : (table[b] ?? 0));
        if (!whole) reader.damaged++;
      }
    },
  };
  return reader;
}

/** A table of the linear radiance of each byte of sRGB (IEC 61966-2-1). */
function linearTable(): Float32Array {
  return Float32Array.from({ length: 256 }, (_, byte) => linearFromSrgb(byte / 255));
}

/** A table of the value of each half float (IEEE 754 binary16), by its bits. */
function halfTable(): Float32Array {
  return Float32Array.from({ length: 0x10000 }, (_, bits) => {
    const sign = bits < 0x8000 ? 1 : -1;
    const exponent = (bits >> 10) & 31;
    const fraction = (bits & 1023) / 1024;
    if (exponent === 31) return fraction === 0 ? sign * Number.POSITIVE_INFINITY : Number.NaN;
    return sign * (exponent === 0 ? 2 ** -14 * fraction : 2 ** (exponent - 15) * (1 + fraction));
  });
}
