/** A pen stroke on a repeating image. Positions and lengths are fractions of its side. */
export interface Stroke {
  readonly x: number;
  readonly y: number;
  /** Slope of the stroke relative to its direction, and how far its middle bends aside. */
  readonly slant: number;
  readonly bend: number;
  readonly length: number;
  /** Whether the stroke runs along y, across the others; false: along x. */
  readonly across: boolean;
}

// Looked up once: tests run where every global is a slow question.
const { abs, ceil, floor, max, min } = Math;

/** Half the width of a stroke in pixels. The pen is the same at every size. */
const HALF_WIDTH_PX = 1.1;

/** Fraction of a stroke at each end over which it becomes thinner. */
const TAPER = 0.15;

/** Ink of one tone at one size: row by row, 0 paper, 1 ink. */
export type Ink = Float32Array;

/** Calls `visit` for each pixel that a stroke touches, with the covered fraction of the pixel. */
export function eachPixel(stroke: Stroke, sidePx: number, visit: (index: number, coverage: number) => void): void {
  const lengthPx = stroke.length * sidePx;
  const steps = max(ceil(lengthPx), 1);
  for (let step = 0; step <= steps; step++) {
    const along = step / steps;
    const u = (stroke.x + (along - 0.5) * stroke.length) * sidePx;
    const v = asideOf(stroke, along) * sidePx;
    const halfPx = HALF_WIDTH_PX * min(1, 0.45 + (0.55 * min(along, 1 - along)) / TAPER);
    for (let offset = -2; offset <= 2; offset++) {
      const across = floor(v) + offset;
      const coverage = min(max(halfPx + 0.5 - abs(across + 0.5 - v), 0), 1);
      if (coverage <= 0) continue;
      const at = wrap(floor(u), sidePx);
      const beside = wrap(across, sidePx);
      visit(stroke.across ? at * sidePx + beside : beside * sidePx + at, coverage);
    }
  }
}

/** Position of the center line of a stroke across its direction, at a point from its start (0) to its end (1). */
function asideOf({ y, slant, bend, length }: Stroke, along: number): number {
  return y + (along - 0.5) * slant * length + bend * (4 * along * (1 - along) - 0.5);
}

/**
 * Mean of the ink along a line parallel to a stroke, `besidePx` pixels beside its center line. Reads every other pixel, which is enough to
 * compare strokes.
 */
export function inkBeside(stroke: Stroke, ink: Ink, sidePx: number, besidePx: number): number {
  const steps = ceil((stroke.length * sidePx) / 2) + 1;
  let sum = 0;
  for (let step = 0; step <= steps; step++) {
    const along = step / steps;
    const at = wrap(floor((stroke.x + (along - 0.5) * stroke.length) * sidePx), sidePx);
    const beside = wrap(floor(asideOf(stroke, along) * sidePx) + besidePx, sidePx);
    sum += ink[stroke.across ? at * sidePx + beside : beside * sidePx + at] ?? 0;
  }
  return sum / (steps + 1);
}

export function drawStroke(stroke: Stroke, ink: Ink, sidePx: number): void {
  eachPixel(stroke, sidePx, (index, coverage) => {
    ink[index] = max(ink[index] ?? 0, coverage);
  });
}

export function toneOf(ink: Ink): number {
  let sum = 0;
  for (const value of ink) sum += value;
  return sum / ink.length;
}

function wrap(value: number, side: number): number {
  return ((value % side) + side) % side;
}
