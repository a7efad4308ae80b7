import { type Gradient, gradientAt, MAX_STOPS, MIN_STOPS, STOP_INTERPOLATIONS, STOP_NUMBERS } from '../../nodes/kit/gradient.ts';
import type { Rgba } from './color-text.ts';

export interface GradientStop {
  readonly position: number;
  readonly color: Rgba;
  /** Index in `STOP_INTERPOLATIONS`: how colors go on to the next stop. */
  readonly interpolation: number;
}

/** A gradient and the index of the stop that was added or moved. */
export interface WithStop {
  readonly gradient: Gradient;
  readonly index: number;
}

/** Precision of positions, and least distance of two stops. */
const STEP = 0.001;

/** How many straight parts stand for an interpolation that is not linear in a drawing. */
const EASE_PARTS = 12;

export function stopsOf(gradient: Gradient): readonly GradientStop[] {
  return Array.from({ length: gradient.length / STOP_NUMBERS }, (_, i) => {
    const [position = 0, r = 0, g = 0, b = 0, a = 1, interpolation = 0] = gradient.slice(STOP_NUMBERS * i, STOP_NUMBERS * (i + 1));
    return { position, color: [r, g, b, a], interpolation };
  });
}

/** Adds a stop with the color that the gradient has at `position`. Returns null if it is full or has a stop there. */
export function withStop(gradient: Gradient, position: number): WithStop | null {
  const stops = stopsOf(gradient);
  const at = round(position);
  if (stops.length >= MAX_STOPS || at < 0 || at > 1 || stops.some((stop) => Math.abs(stop.position - at) < STEP / 2)) return null;
  const index = stops.filter((stop) => stop.position < at).length;
  const interpolation = stops[Math.max(index - 1, 0)]?.interpolation ?? 0;
  return { gradient: listOf(inserted(stops, index, { position: at, color: colorAt(gradient, at), interpolation })), index };
}

/** Adds a stop in the middle of the widest gap. */
export function withStopInGap(gradient: Gradient): WithStop | null {
  const borders = [0, ...stopsOf(gradient).map(({ position }) => position), 1];
  const gaps = borders.slice(1).map((to, i) => ({ to, from: borders[i] ?? 0 }));
  const widest = gaps.reduce((a, b) => (b.to - b.from > a.to - a.from ? b : a));
  return withStop(gradient, (widest.from + widest.to) / 2);
}

export function canLoseStop(gradient: Gradient): boolean {
  return gradient.length > STOP_NUMBERS * MIN_STOPS;
}

export function withoutStop(gradient: Gradient, index: number): Gradient {
  return canLoseStop(gradient) ? listOf(stopsOf(gradient).filter((_, i) => i !== index)) : gradient;
}

/** Moves a stop, past others too. Where another stop is, it takes the nearest free position. */
export function withStopAt(gradient: Gradient, index: number, position: number): WithStop {
  const stops = stopsOf(gradient);
  const moved = stops[index];
  if (!moved) return { gradient, index };
  const others = stops.filter((_, i) => i !== index);
  const at = freePosition(others, Math.min(Math.max(round(position), 0), 1));
  const place = others.filter((stop) => stop.position < at).length;
  return { gradient: listOf(inserted(others, place, { ...moved, position: at })), index: place };
}

/** Replaces the color or the interpolation of a stop. */
export function withStopChanged(gradient: Gradient, index: number, change: Partial<Omit<GradientStop, 'position'>>): Gradient {
  return listOf(stopsOf(gradient).map((stop, i) => (i === index ? { ...stop, ...change } : stop)));
}

/** Swaps both ends. Interpolations stay between the same two colors. */
export function flipped(gradient: Gradient): Gradient {
  const stops = [...stopsOf(gradient)].reverse();
  return listOf(
    stops.map((stop, i) => ({
      ...stop,
      position: round(1 - stop.position),
      interpolation: (stops[i + 1] ?? stops[0] ?? stop).interpolation,
    })),
  );
}

/** The CSS image of a gradient, from left to right. */
export function gradientCss(gradient: Gradient): string {
  const stops = stopsOf(gradient);
  const parts = stops.flatMap((stop, i) => {
    const next = stops[i + 1];
    const here = `${rgba(stop.color)} ${percent(stop.position)}`;
    const name = STOP_INTERPOLATIONS[stop.interpolation];
    if (!next || name === 'linear') return [here];
    if (name === 'hold') return [here, `${rgba(stop.color)} ${percent(next.position)}`];
    return [here, ...easedParts(gradient, stop.position, next.position)];
  });
  return `linear-gradient(to right, ${parts.join(', ')})`;
}

function easedParts(gradient: Gradient, from: number, to: number): string[] {
  return Array.from({ length: EASE_PARTS - 1 }, (_, i) => {
    const at = from + ((to - from) * (i + 1)) / EASE_PARTS;
    return `${rgba(colorAt(gradient, at))} ${percent(at)}`;
  });
}

/** The color at a position, with straight alpha. */
function colorAt(gradient: Gradient, position: number): Rgba {
  const numbers = new Float32Array(4);
  gradientAt(gradient, position, numbers);
  const [r = 0, g = 0, b = 0, a = 0] = numbers;
  const straight = (channel: number) => (a > 0 ? Math.round((channel / a) * 1000) / 1000 : 0);
  return [straight(r), straight(g), straight(b), Math.round(a * 1000) / 1000];
}

function inserted(stops: readonly GradientStop[], index: number, stop: GradientStop): readonly GradientStop[] {
  return [...stops.slice(0, index), stop, ...stops.slice(index)];
}

function freePosition(others: readonly GradientStop[], wanted: number): number {
  const isFree = (at: number) => at >= 0 && at <= 1 && others.every((stop) => Math.abs(stop.position - at) >= STEP / 2);
  for (let by = 0; ; by += STEP) for (const at of [round(wanted + by), round(wanted - by)]) if (isFree(at)) return at;
}

function listOf(stops: readonly GradientStop[]): Gradient {
  return stops.flatMap(({ position, color, interpolation }) => [position, ...color, interpolation]);
}

function rgba([r, g, b, a]: Rgba): string {
  return `rgb(${[r, g, b].map((channel) => Math.round(channel * 255)).join(' ')} / ${a})`;
}

function percent(position: number): string {
  return `${Number((position * 100).toFixed(2))}%`;
}

function round(number: number): number {
  return Math.round(number / STEP) / (1 / STEP);
}
