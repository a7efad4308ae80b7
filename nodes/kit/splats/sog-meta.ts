import { checkCount, SplatError, type Splats } from './splats.ts';

/** `meta.json` of SOG, version 2 (PlayCanvas, “The SOG Format”), checked. */
export interface SogMeta {
  readonly count: number;
  readonly antialias: boolean;
  /** Limits of the positions, of which the sign is kept and the logarithm of 1 + the magnitude is stored. */
  readonly mins: readonly number[];
  readonly maxs: readonly number[];
  /** The logarithms of scales. */
  readonly scales: readonly number[];
  /** Coefficients of degree 0. */
  readonly base: readonly number[];
  readonly harmonics: { readonly degree: Splats['degree']; readonly count: number; readonly codebook: readonly number[] } | null;
  /** Names of the images: positions low and high, scales, rotations, base; with harmonics also centroids and labels. */
  readonly files: readonly string[];
}

/** The name of the document in a SOG file. */
export const SOG_META = 'meta.json';

/** The parts of the document, with the number of images of each. */
const PARTS = { means: 2, scales: 1, quats: 1, sh0: 1 } as const;
const CODEBOOK = 256;
const MAX_PALETTE = 65_536;

/**
 * Reads and checks `meta.json` of a SOG file.
 *
 * @param text The document.
 * @throws SplatError
 *
 * @example
 * const { files } = readSogMeta(text);
 */
export function readSogMeta(text: string): SogMeta {
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    throw new SplatError(`its ${SOG_META} is not valid JSON`);
  }
  const meta = record(json, SOG_META);
  if (!('means' in meta)) throw new SplatError(`its ${SOG_META} describes no splats`);
  if (meta.version !== 2) {
    throw new SplatError(
      `it is SOG version ${String(meta.version ?? 1)}; only version 2 can be read`,
      'Convert it with a newer splat-transform.',
    );
  }
  if (typeof meta.count !== 'number') throw new SplatError('its number of splats is invalid');
  checkCount(meta.count);
  const files = Object.entries(PARTS).flatMap(([part, count]) => names(record(meta[part], part).files, part, count));
  const { mins, maxs } = record(meta.means, 'means');
  const harmonics = meta.shN === undefined ? null : readHarmonics(record(meta.shN, 'shN'));
  return {
    count: meta.count,
    antialias: meta.antialias === true,
    mins: numbers(mins, 'means.mins', 3),
    maxs: numbers(maxs, 'means.maxs', 3),
    scales: numbers(record(meta.scales, 'scales').codebook, 'scales.codebook', CODEBOOK),
    base: numbers(record(meta.sh0, 'sh0').codebook, 'sh0.codebook', CODEBOOK),
    harmonics,
    files: harmonics === null ? files : [...files, ...names(record(meta.shN, 'shN').files, 'shN', 2)],
  };
}

function readHarmonics({ count, bands, codebook }: Readonly<Record<string, unknown>>): SogMeta['harmonics'] {
  const degree = ([1, 2, 3] as const).find((each) => each === bands);
  if (degree === undefined) throw new SplatError('its "shN.bands" is not 1, 2 or 3');
  if (!Number.isInteger(count) || !(Number(count) >= 1 && Number(count) <= MAX_PALETTE)) {
    throw new SplatError(`its "shN.count" is not between 1 and ${MAX_PALETTE}`);
  }
  return { degree, count: Number(count), codebook: numbers(codebook, 'shN.codebook', CODEBOOK) };
}

function record(value: unknown, name: string): Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw new SplatError(`its "${name}" is missing or no object`);
  return value as Readonly<Record<string, unknown>>;
}

function numbers(value: unknown, name: string, count: number): readonly number[] {
  if (!Array.isArray(value) || value.length !== count || !value.every(Number.isFinite)) {
    throw new SplatError(`its "${name}" is not a list of ${count} numbers`);
  }
  return value;
}

/** Names of files beside the document. */
function names(value: unknown, part: string, count: number): readonly string[] {
  if (!Array.isArray(value) || value.length !== count)
    throw new SplatError(`its "${part}" does not have ${count === 1 ? 'one file' : '2 files'}`);
  return value.map((name: unknown) => {
    if (typeof name !== 'string' || !/^[^/\\:\0]{1,128}$/.test(name) || name === '.' || name === '..') {
      throw new SplatError(`its "${part}" has the file ${JSON.stringify(name)}, which is not beside it`);
    }
    return name;
  });
}
