import { drawStroke, type Ink, inkBeside, type Stroke, toneOf } from './strokes.ts';

/**
 * Tonal art maps of Praun, Hoppe, Webb and Finkelstein, Real-Time Hatching, SIGGRAPH 2001, section 3: pictures of several tones,
 * each at several sizes, whose strokes nest. What is drawn in a light tone is drawn in all darker ones, and what is drawn at a small
 * size in all larger ones, so that strokes come and go one by one when tone or distance change.
 */
export interface TonalArtMaps {
  /** Sides of the sizes, largest first. */
  readonly sidesPx: readonly number[];
  /** By tone, lightest first, and size. */
  readonly ink: readonly (readonly Ink[])[];
  readonly strokes: readonly (readonly (readonly Stroke[])[])[];
}

/** How much of the paper is covered. Above the fourth tone strokes cross the others. */
export const TONES = [0.1, 0.22, 0.36, 0.5, 0.65, 0.8] as const;
const CROSSES_FROM = 3;

/** Smaller than the last, a stroke would be as large as the picture: there what is left is the mean. */
const SIDES_PX = [256, 128, 64, 32, 16] as const;

/** Of so many random strokes the one is drawn that fits best between those that are there. */
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

/** Looks at the paper around a stroke too, near and farther, as the paper's pyramid of blurred pictures does. */
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

/** Mulberry32 (Tommy Ettinger, public domain): the same numbers everywhere. */
function createRandom(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
