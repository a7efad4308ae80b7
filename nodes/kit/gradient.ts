/**
 * A gradient as the value of a param: stops `[position, red, green, blue, alpha, interpolation, …]`, sorted by position. Positions and
 * colors lie in [0, 1]; colors are display-referred sRGB with straight alpha. The interpolation of a stop applies until the next one.
 * Before the first stop and after the last the gradient is constant.
 *
 * Colors are interpolated as premultiplied sRGB, as CSS does, so that a transparent stop does not darken its neighbors.
 */
export type Gradient = readonly number[];

/** How many numbers a stop takes. */
export const STOP_NUMBERS = 6;

/** The fewest stops of a gradient. */
export const MIN_STOPS = 2;

/** The most stops of a gradient. */
export const MAX_STOPS = 16;

/** How many numbers a gradient takes in the program's slots. A gradient with fewer stops repeats its last stop. */
export const GRADIENT_NUMBERS = STOP_NUMBERS * MAX_STOPS;

/** The interpolations by their stored number. */
export const STOP_INTERPOLATIONS = ['linear', 'ease-in-out', 'hold'] as const;

/** From black to white. */
export const BLACK_TO_WHITE: Gradient = [0, 0, 0, 0, 1, 0, 1, 1, 1, 1, 1, 0];

/**
 * Checks whether a value is a gradient.
 *
 * @param value Any value, such as one from a project file.
 * @returns Null for a gradient; else what the value must be, in words for a diagnostic.
 *
 * @example
 * gradientMisfit(BLACK_TO_WHITE); // null
 */
export function gradientMisfit(value: unknown): string | null {
  const isList = Array.isArray(value) && value.length % STOP_NUMBERS === 0 && value.every(Number.isFinite);
  if (!isList || value.length < STOP_NUMBERS * MIN_STOPS || value.length > GRADIENT_NUMBERS)
    return `a gradient of ${MIN_STOPS} to ${MAX_STOPS} stops, [position, red, green, blue, alpha, interpolation, …]`;
  const numbers = value as Gradient;
  for (let i = 0; i < numbers.length; i += STOP_NUMBERS) {
    if (numbers.slice(i, i + STOP_NUMBERS - 1).some((number) => number < 0 || number > 1))
      return 'a gradient whose positions and colors lie from 0 to 1';
    if (STOP_INTERPOLATIONS[numbers[i + STOP_NUMBERS - 1] ?? 0] === undefined)
      return `a gradient with interpolations from 0 to ${STOP_INTERPOLATIONS.length - 1}`;
    if (i > 0 && (numbers[i] ?? 0) <= (numbers[i - STOP_NUMBERS] ?? 0))
      return 'a gradient with each stop further right than the one before';
  }
  return null;
}

/**
 * Samples a gradient at evenly spaced positions, the first at 0 and the last at 1.
 *
 * @param gradient A gradient, padded or not.
 * @param colors Receives four numbers per position, with premultiplied alpha; at least two positions.
 *
 * @example
 * sampleGradient(BLACK_TO_WHITE, new Float32Array(8)); // [0, 0, 0, 1, 1, 1, 1, 1]
 */
export function sampleGradient(gradient: ArrayLike<number>, colors: Float32Array): void {
  const last = colors.length / 4 - 1;
  for (let i = 0; i <= last; i++) gradientAt(gradient, i / last, colors, 4 * i);
}

/**
 * Computes the color at one position.
 *
 * @param gradient A gradient, padded or not.
 * @param colors Receives four numbers from the index `at`, with premultiplied alpha.
 *
 * @example
 * gradientAt(BLACK_TO_WHITE, 0.25, new Float32Array(4)); // [0.25, 0.25, 0.25, 1]
 */
export function gradientAt(gradient: ArrayLike<number>, position: number, colors: Float32Array, at = 0): void {
  const count = countStops(gradient);
  let next = 0;
  while (next < count && (gradient[STOP_NUMBERS * next] ?? 0) <= position) next++;
  const from = STOP_NUMBERS * Math.max(next - 1, 0);
  const to = STOP_NUMBERS * Math.min(next, count - 1);
  const t = from === to ? 0 : eased((position - (gradient[from] ?? 0)) / ((gradient[to] ?? 0) - (gradient[from] ?? 0)), gradient[from + 5]);
  const fromAlpha = (1 - t) * (gradient[from + 4] ?? 0);
  const toAlpha = t * (gradient[to + 4] ?? 0);
  for (let channel = 0; channel < 3; channel++)
    colors[at + channel] = fromAlpha * (gradient[from + 1 + channel] ?? 0) + toAlpha * (gradient[to + 1 + channel] ?? 0);
  colors[at + 3] = fromAlpha + toAlpha;
}

function eased(t: number, interpolation = 0): number {
  const name = STOP_INTERPOLATIONS[interpolation];
  if (name === 'hold') return 0;
  return name === 'ease-in-out' ? t * t * (3 - 2 * t) : t;
}

/** The number of stops without padding. Padding begins at the first stop whose position does not increase. */
function countStops(gradient: ArrayLike<number>): number {
  let count = 1;
  while (STOP_NUMBERS * count < gradient.length && (gradient[STOP_NUMBERS * count] ?? 0) > (gradient[STOP_NUMBERS * (count - 1)] ?? 0))
    count++;
  return count;
}
