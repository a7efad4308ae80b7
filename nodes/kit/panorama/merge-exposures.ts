import { createRowReader, isDisplayReferred, type PanoramaPixels, ROWS_PER_STEP, startOfRow } from './pixels.ts';

/** Panoramas of the same place at different exposures, merged to one with the brightness of its lamps. */
export interface MergedExposures {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly channels: 3;
  /** Linear-sRGB radiance, rows from the top; white of the first shot is 1. */
  readonly data: Float32Array;
  /** For each shot, its exposure relative to the first, in stops; a darker shot has less than 0. */
  readonly stops: readonly number[];
  /** Part of the sphere that is white in all shots, in [0, 1]. */
  readonly whitePart: number;
}

/** Bytes from this value on count as clipped, because compression lowers white a little. */
const CLIPPED_BYTE = 250;
/** Bytes between these limits tell the exposure: darker ones are too coarse, brighter ones may be clipped. */
const [LEAST_BYTE, MOST_BYTE] = [12, 240] as const;
/** The fewest samples that tell an exposure. */
const MIN_SAMPLES = 30;
/** About as many pixels are compared at most to measure an exposure; those that tell may be few. */
const MOST_COMPARED = 2_000_000;
/** Weight of a clipped sample, which counts only where all shots are clipped. */
const FAINT = 1e-6;

/**
 * Merges shots of one panorama, taken from one place at different exposures, to linear radiance (after Debevec and Malik 1997, “Recovering
 * High Dynamic Range Radiance Maps from Photographs”, with the response curve of sRGB). Exposures are measured: between a shot and the next
 * darker one, by the median ratio of pixels that neither of them clips. Each pixel is the mean of the shots, weighted by how exact their
 * bytes are there. It yields after about a millisecond of work.
 *
 * @param shots Two or more display-referred panoramas of one size, in any order.
 * @param stopsApart Exposure difference of neighboring shots in stops; 0 to measure it.
 * @throws Error for shots that cannot be merged, with a reason and a remedy for users.
 *
 * @example
 * const { data, widthPx, heightPx } = runWhole(mergeExposures([bright, dark], 0));
 */
export function* mergeExposures(shots: readonly PanoramaPixels[], stopsApart: number): Generator<undefined, MergedExposures> {
  const [first] = shots;
  if (!first || shots.length < 2) throw new Error('it takes two exposures or more. Choose another shot of the same panorama');
  const { widthPx, heightPx } = first;
  for (const [i, shot] of shots.entries()) refuse(shot, first, i + 1);
  const stops = yield* exposuresOf(shots, stopsApart);
  const data = new Float32Array(widthPx * heightPx * 3);
  const weights = new Float32Array(widthPx * 3);
  const row = new Float32Array(widthPx * 3);
  const readers = shots.map(createRowReader);
  const darkest = stops.indexOf(Math.min(...stops));
  let [white, all] = [0, 0];
  for (let y = 0; y < heightPx; y++) {
    if (y % ROWS_PER_STEP === 0) yield;
    weights.fill(0);
    const into = data.subarray(y * widthPx * 3, (y + 1) * widthPx * 3);
    const sr = Math.sin(((y + 0.5) / heightPx) * Math.PI);
    all += sr * widthPx;
    for (const [k, shot] of shots.entries()) {
      readers[k]?.read(y, row);
      const exposure = 2 ** (stops[k] ?? 0);
      for (let x = 0, at = startOfRow(shot, y); x < widthPx; x++, at += shot.channels) {
        const isClipped = largest(shot, at) >= CLIPPED_BYTE;
        if (isClipped && k === darkest) white += sr;
        for (let c = x * 3; c < x * 3 + 3; c++) {
          // The noise of bytes grows slowly with light, so a longer exposure is more exact until it clips.
          const weight = isClipped ? (k === darkest ? FAINT : 0) : exposure * ((row[c] ?? 0) + FAINT);
          into[c] = (into[c] ?? 0) + (weight * (row[c] ?? 0)) / exposure;
          weights[c] = (weights[c] ?? 0) + weight;
        }
      }
    }
    for (let i = 0; i < into.length; i++) into[i] = (into[i] ?? 0) / (weights[i] || 1);
  }
  return { widthPx, heightPx, channels: 3, data, stops, whitePart: white / all };
}

function refuse(shot: PanoramaPixels, { widthPx, heightPx }: PanoramaPixels, number: number): void {
  if (!isDisplayReferred(shot)) {
    throw new Error(`shot ${number} contains the full range of brightness already. Use it alone, with a Panorama node`);
  }
  if (shot.widthPx === widthPx && shot.heightPx === heightPx) return;
  const [size, wanted] = [`${shot.widthPx} × ${shot.heightPx}`, `${widthPx} × ${heightPx}`];
  throw new Error(`shot ${number} has ${size} pixels, and the first has ${wanted}. Export all shots in one size`);
}

function largest({ data, channels }: PanoramaPixels, at: number): number {
  const red = data[at] ?? 0;
  return channels === 1 ? red : Math.max(red, data[at + 1] ?? 0, data[at + 2] ?? 0);
}

/** The exposure of each shot relative to the first, in stops. */
function* exposuresOf(shots: readonly PanoramaPixels[], stopsApart: number): Generator<undefined, readonly number[]> {
  const order = shots.map((shot, i) => ({ i, brightness: meanByte(shot) })).sort((a, b) => b.brightness - a.brightness);
  const stops: number[] = shots.map(() => 0);
  for (let k = 1; k < order.length; k++) {
    yield;
    const [brighter, darker] = [order[k - 1]?.i ?? 0, order[k]?.i ?? 0];
    const apart = stopsApart > 0 ? stopsApart : measureStops(shots[brighter] as PanoramaPixels, shots[darker] as PanoramaPixels);
    if (apart === null) {
      throw new Error(
        `shots ${Math.min(brighter, darker) + 1} and ${Math.max(brighter, darker) + 1} show nothing in common that is neither black nor white. Add a shot between them, or set “Stops apart”`,
      );
    }
    stops[darker] = (stops[brighter] ?? 0) - apart;
  }
  const [reference = 0] = stops;
  return stops.map((value) => value - reference);
}

function meanByte({ data }: PanoramaPixels): number {
  const step = Math.max(1, Math.floor(data.length / MOST_COMPARED));
  let [sum, count] = [0, 0];
  for (let i = 0; i < data.length; i += step) {
    sum += data[i] ?? 0;
    count++;
  }
  return sum / Math.max(1, count);
}

/** By how many stops a shot is brighter than another; null if no pixels tell. */
function measureStops(brighter: PanoramaPixels, darker: PanoramaPixels): number | null {
  const { widthPx, heightPx } = brighter;
  const [a, b] = [new Float32Array(widthPx * 3), new Float32Array(widthPx * 3)];
  const [readA, readB] = [createRowReader(brighter), createRowReader(darker)];
  const stepX = Math.max(1, Math.floor(Math.sqrt((widthPx * heightPx) / MOST_COMPARED)));
  const ratios: number[] = [];
  for (let y = 0; y < heightPx; y += stepX) {
    readA.read(y, a);
    readB.read(y, b);
    for (let x = 0; x < widthPx; x += stepX) {
      const [atA, atB] = [startOfRow(brighter, y) + x * brighter.channels, startOfRow(darker, y) + x * darker.channels];
      for (let c = 0; c < Math.min(brighter.channels, darker.channels, 3); c++) {
        const [byteA, byteB] = [brighter.data[atA + c] ?? 0, darker.data[atB + c] ?? 0];
        if (byteA > MOST_BYTE || byteB < LEAST_BYTE) continue;
        ratios.push(Math.log2((a[x * 3 + c] ?? 0) / (b[x * 3 + c] ?? 1)));
      }
    }
  }
  if (ratios.length < MIN_SAMPLES) return null;
  ratios.sort((one, other) => one - other);
  return Math.max(0, ratios[ratios.length >> 1] ?? 0);
}
