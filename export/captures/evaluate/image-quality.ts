/** Two images of one size as RGBA, 8 bits, in display-referred sRGB. Pixels of `shown` with alpha 0 are left out. */
export interface ImagePair {
  readonly shown: ArrayLike<number>;
  readonly truth: ArrayLike<number>;
  readonly widthPx: number;
  readonly heightPx: number;
  /**
   * Images of all directions: a pixel counts by the solid angle that it shows, so that the poles do not count most (Sun, Lu and Yu,
   * “Weighted-to-spherically-uniform quality evaluation for omnidirectional video”, IEEE SPL 2017).
   */
  readonly isAround?: boolean;
}

export interface ImageQuality {
  /** Peak signal-to-noise ratio over red, green and blue, dB; infinite for equal images. */
  readonly psnrDb: number;
  /** Mean structural similarity of the luma, from -1 to 1. NaN if no window is covered. */
  readonly ssim: number;
  /** Mean of |ΔCb| + |ΔCr|, in steps of 8 bits. */
  readonly chromaError: number;
  /** The part of the image that is compared, from 0 to 1. */
  readonly covered: number;
}

/** Compares two images over the pixels that both have. */
export function compareImages(pair: ImagePair): ImageQuality {
  const { shown, truth, widthPx } = pair;
  let square = 0;
  let chroma = 0;
  let compared = 0;
  let whole = 0;
  for (let at = 0; at < shown.length; at += 4) {
    const weight = weightOf(pair, Math.floor(at / (4 * widthPx)) + 0.5);
    whole += weight;
    if (shown[at + 3] === 0) continue;
    compared += weight;
    for (let c = 0; c < 3; c++) square += weight * ((shown[at + c] ?? 0) - (truth[at + c] ?? 0)) ** 2;
    chroma += weight * chromaErrorAt(pair, at);
  }
  return {
    psnrDb: 10 * Math.log10((255 * 255) / (square / (3 * compared))),
    ssim: meanSsim(pair),
    chromaError: chroma / compared,
    covered: compared / whole,
  };
}

/** How much a place counts. `y`: in pixels from the top edge. */
function weightOf({ isAround, heightPx }: ImagePair, y: number): number {
  return isAround ? Math.sin((Math.PI * y) / heightPx) : 1;
}

/**
 * |ΔCb| + |ΔCr| of the pixel whose red is at `at`, in steps of 8 bits, with the coefficients of BT.601: what differs without regard to
 * brightness (Dupont de Dinechin and Paljic, “From Real to Virtual”, WEVR 2020, §3.3).
 */
export function chromaErrorAt({ shown, truth }: ImagePair, at: number): number {
  const [r, g, b] = [0, 1, 2].map((c) => (shown[at + c] ?? 0) - (truth[at + c] ?? 0)) as [number, number, number];
  return Math.abs(-0.168736 * r - 0.331264 * g + 0.5 * b) + Math.abs(0.5 * r - 0.418688 * g - 0.081312 * b);
}

/** Pixels on each side of the middle of a window. */
const RADIUS = 5;
const SIDE = 2 * RADIUS + 1;
const SIGMA = 1.5;
const BELL = Array.from({ length: SIDE }, (_, i) => Math.exp(-((i - RADIUS) ** 2) / (2 * SIGMA ** 2)));
const BELL_SUM = BELL.reduce((sum, value) => sum + value);
/** Weights of a row or column of a window. */
const WEIGHTS = BELL.map((value) => value / BELL_SUM);
const C1 = (0.01 * 255) ** 2;
const C2 = (0.03 * 255) ** 2;

/**
 * Structural similarity of the luma, with the windows and constants of Wang et al., “Image quality assessment”, IEEE TIP 2004: 11 × 11 pixels
 * around each pixel, weighted by a Gaussian of 1.5 pixels, wholly inside the image. Windows with a pixel that is left out do not count.
 */
function meanSsim(pair: ImagePair): number {
  const { shown, truth, widthPx, heightPx } = pair;
  const a = lumaOf(shown);
  const b = lumaOf(truth);
  const meansOf = (value: (at: number) => number) =>
    windowMeans(
      a.map((_, at) => value(at)),
      widthPx,
      heightPx,
    );
  const meanA = meansOf((at) => a[at] ?? 0);
  const meanB = meansOf((at) => b[at] ?? 0);
  const squares = meansOf((at) => (a[at] ?? 0) ** 2 + (b[at] ?? 0) ** 2);
  const products = meansOf((at) => (a[at] ?? 0) * (b[at] ?? 0));
  const leftOut = meansOf((at) => (shown[4 * at + 3] === 0 ? 1 : 0));
  const columns = widthPx - SIDE + 1;
  let sum = 0;
  let windows = 0;
  for (let i = 0; i < meanA.length; i++) {
    if (leftOut[i] !== 0) continue;
    const weight = weightOf(pair, Math.floor(i / columns) + SIDE / 2);
    const [x, y] = [meanA[i] ?? 0, meanB[i] ?? 0];
    const variances = (squares[i] ?? 0) - x * x - y * y;
    const covariance = (products[i] ?? 0) - x * y;
    sum += (weight * ((2 * x * y + C1) * (2 * covariance + C2))) / ((x * x + y * y + C1) * (variances + C2));
    windows += weight;
  }
  return sum / windows;
}

/** Means of all windows that are wholly inside an image, row by row. */
function windowMeans(image: Float64Array, widthPx: number, heightPx: number): Float64Array {
  const columns = Math.max(0, widthPx - SIDE + 1);
  const rows = Math.max(0, heightPx - SIDE + 1);
  const across = new Float64Array(columns * heightPx);
  for (let i = 0; i < across.length; i++) across[i] = weightedSum(image, Math.floor(i / columns) * widthPx + (i % columns), 1);
  return Float64Array.from({ length: columns * rows }, (_, i) => weightedSum(across, i, columns));
}

function weightedSum(values: Float64Array, from: number, step: number): number {
  let sum = 0;
  for (let i = 0; i < SIDE; i++) sum += (WEIGHTS[i] ?? 0) * (values[from + i * step] ?? 0);
  return sum;
}

function lumaOf(rgba: ArrayLike<number>): Float64Array {
  return Float64Array.from(
    { length: rgba.length / 4 },
    (_, i) => 0.299 * (rgba[4 * i] ?? 0) + 0.587 * (rgba[4 * i + 1] ?? 0) + 0.114 * (rgba[4 * i + 2] ?? 0),
  );
}

/** Colors from no error to `FULL_SCALE`, near those of plasma of Matplotlib. */
const SCALE = [
  [13, 8, 135],
  [126, 3, 168],
  [204, 71, 120],
  [248, 149, 64],
  [240, 249, 33],
] as const;
const FULL_SCALE = 25.5;

/** A picture of `chromaErrorAt`: dark blue is 0, yellow 25.5 or more, as with the factor 10 of COLIBRI VR. Pixels left out are black. */
export function chromaErrorMap(pair: ImagePair): Uint8ClampedArray<ArrayBuffer> {
  const { shown } = pair;
  const map = new Uint8ClampedArray(shown.length);
  for (let at = 0; at < shown.length; at += 4) {
    map[at + 3] = 255;
    if (shown[at + 3] === 0) continue;
    const place = Math.min(1, chromaErrorAt(pair, at) / FULL_SCALE) * (SCALE.length - 1);
    const first = Math.min(Math.floor(place), SCALE.length - 2);
    const [low, high] = [SCALE[first], SCALE[first + 1]];
    const part = place - first;
    for (let c = 0; c < 3; c++) map[at + c] = (low?.[c] ?? 0) * (1 - part) + (high?.[c] ?? 0) * part;
  }
  return map;
}
