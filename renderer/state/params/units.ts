import { getOwn } from '../../../export/graph/record.ts';
import type { NumberParam, Unit } from '../../../nodes/kit/definition.ts';

/** How a stored number is shown and typed: radians as degrees, all else as it is. */
export interface ShownUnit {
  readonly suffix: string;
  /** Shown value = stored value × this. */
  readonly shownPerStored: number;
}

const SHOWN: Readonly<Record<Unit, ShownUnit>> = {
  m: { suffix: 'm', shownPerStored: 1 },
  s: { suffix: 's', shownPerStored: 1 },
  rad: { suffix: '°', shownPerStored: 180 / Math.PI },
  px: { suffix: 'px', shownPerStored: 1 },
  K: { suffix: 'K', shownPerStored: 1 },
  Hz: { suffix: 'Hz', shownPerStored: 1 },
  cd: { suffix: 'cd', shownPerStored: 1 },
  ratio: { suffix: '', shownPerStored: 1 },
  none: { suffix: '', shownPerStored: 1 },
};

export function shownUnit(unit: Unit | undefined): ShownUnit {
  return SHOWN[unit ?? 'none'];
}

export interface NumberRange {
  /** Stored units. */
  readonly min: number | undefined;
  readonly max: number | undefined;
  readonly step: number;
}

/** A step fine enough for the range where the definition names none. */
export function rangeOf(param: Pick<NumberParam, 'min' | 'max' | 'step' | 'unit'>): NumberRange {
  const { min, max } = param;
  if (param.step !== undefined) return { min, max, step: param.step };
  if (min === undefined || max === undefined || max <= min) return { min, max, step: 0.01 / shownUnit(param.unit).shownPerStored };
  // A power of ten with 100 to 1,000 steps over the range.
  return { min, max, step: 10 ** Math.floor(Math.log10((max - min) / 100)) };
}

export function clampTo(value: number, { min, max }: Pick<NumberRange, 'min' | 'max'>): number {
  return Math.min(Math.max(value, min ?? Number.NEGATIVE_INFINITY), max ?? Number.POSITIVE_INFINITY);
}

/** At most four decimals, without trailing zeros; very small and very large numbers in powers of ten. */
export function formatNumber(shown: number): string {
  const size = Math.abs(shown);
  if (size === 0) return '0';
  if (size < 1e-4 || size >= 1e7) return shown.toExponential(3);
  const text = shown.toFixed(4);
  return text.includes('.') ? text.replace(/\.?0+$/, '') || '0' : text;
}

/** Units that people may type, each with how much of the stored one it is. */
const TYPED: Readonly<Partial<Record<Unit, Readonly<Record<string, number>>>>> = {
  m: { mm: 0.001, cm: 0.01, dm: 0.1, m: 1, km: 1000, in: 0.0254, ft: 0.3048 },
  s: { ms: 0.001, s: 1, min: 60, h: 3600 },
  rad: { '°': Math.PI / 180, deg: Math.PI / 180, rad: 1, turn: 2 * Math.PI, turns: 2 * Math.PI },
  Hz: { Hz: 1, kHz: 1000 },
  ratio: { '%': 0.01 },
  none: { '%': 0.01 },
};

/** How much of the stored unit a typed one is; undefined where it is a unit of something else, or none. */
export function storedPerTyped(typed: string, unit: Unit | undefined): number | undefined {
  if (typed === '') return 1 / shownUnit(unit).shownPerStored;
  return getOwn(TYPED[unit ?? 'none'] ?? {}, typed) ?? (typed === shownUnit(unit).suffix ? 1 : undefined);
}

/** What was typed, in stored units; null where it is no number. Takes a decimal comma, and any unit of the same quantity. */
export function parseNumber(text: string, unit: Unit | undefined): number | null {
  const [, number, typed = ''] = /^([-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:e[-+]?\d+)?)\s*(\S*)$/i.exec(text.trim()) ?? [];
  const factor = number === undefined ? undefined : storedPerTyped(typed, unit);
  if (number === undefined || factor === undefined) return null;
  const value = Number(number.replace(',', '.')) * factor;
  return Number.isFinite(value) ? value : null;
}
