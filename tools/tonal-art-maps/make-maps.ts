import { drawStroke, type Ink, inkBeside, type Stroke, toneOf } from './strokes.ts';

/**
 * Tonal art maps of Praun, Hoppe, Webb and Finkelstein, Real-Time Hatching, SIGGRAPH 2001, section 3: images of several tones, each at
 * several sizes, with nested strokes. A stroke of a light tone is also in all darker tones, and a stroke of a small size is also in all
 * larger sizes, so that strokes come and go one by one when tone or distance change.
 */
export interface TonalArtMaps {
  /** Side lengths of the square images, largest first. */
  readonly sidesPx: readonly number[];
  /** Drawn images, by tone (lightest first) and size. */
  readonly ink: readonly (readonly Ink[])[];
  readonly strokes: readonly (readonly (readonly Stroke[])[])[];
}

/** The tones, as the covered fraction of the paper. From the fourth tone on, new strokes cross the others. */
export const TONES = [0.1, 0.22, 0.36, 0.5, 0.65, 0.8] as const;
const CROSSES_FROM = 3;

/**
 * Side lengths of the sizes that are drawn. At smaller sizes a stroke would be as large as the image, so these are means of the smallest
 * one.
 */
const SIDES_PX = [256, 128, 64, 32, 16] as const;

/** Number of random strokes that are tried for each stroke. The one with the least ink around it is drawn. */
const CANDIDATES = 40;

const SEED = 2001;

export function makeTonalArtMaps(): TonalArtMaps {
  const random = createRandom(SEED);
  const ink: Ink[][] = [];
  const strokes: Stroke[][][] = [];
  for (const [tone, wanted] of TONES.entries()) {
    const inkOfTone: Ink[] = [];
    const strokesOfTone: Stroke[][] = [];
    // From the smallest size up: each starts with what the size below has.
    for (let size = SIDES_PX.length - 1; size >= 0; size--) {
      const sidePx = SIDES_PX[size] ?? 1;
      const known = [...new Set([...(strokes[tone - 1]?.[size] ?? []), ...(strokesOfTone[size + 1] ?? [])])];
      const drawn: Ink = new Float32Array(sidePx * sidePx);
      for (const stroke of known) drawStroke(stroke, drawn, sidePx);
      while (toneOf(drawn) < wanted) {
        const stroke = bestOf(drawn, sidePx, () => randomStroke(random, tone >= CROSSES_FROM));
        known.push(stroke);
        drawStroke(stroke, drawn, sidePx);
      }
      inkOfTone[size] = drawn;
      strokesOfTone[size] = known;
    }
    ink.push(inkOfTone);
    strokes.push(strokesOfTone);
  }
  return { sidesPx: SIDES_PX, ink, strokes };
}

function randomStroke(random: () => number, across: boolean): Stroke {
  return {
    x: random(),
    y: random(),
    slant: (random() - 0.5) * 0.07,
    bend: (random() - 0.5) * 0.012,
    length: 0.3 + 0.6 * random(),
    across,
  };
}

/** Distances from the middle of a stroke at which the ink is compared, near and far, in place of the paper's pyramid of blurred images. */
const BESIDE_PX = [-7, -3, 0, 3, 7] as const;

function bestOf(drawn: Ink, sidePx: number, make: () => Stroke): Stroke {
  let best = make();
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < CANDIDATES; i++) {
    const stroke = i === 0 ? best : make();
    const inWay = inkAround(stroke, drawn, sidePx);
    if (inWay < least) {
      best = stroke;
      least = inWay;
    }
  }
  return best;
}

function inkAround(stroke: Stroke, drawn: Ink, sidePx: number): number {
  let sum = 0;
  for (const besidePx of BESIDE_PX) sum += inkBeside(stroke, drawn, sidePx, besidePx) / (1 + Math.abs(besidePx));
  return sum;
}

/** Seeded random numbers, the same on all systems (Mulberry32 by Tommy Ettinger, public domain). */
function createRandom(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
