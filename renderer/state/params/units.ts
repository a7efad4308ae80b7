import { getOwn } from '../../../export/graph/record.ts';
import type { NumberParam, Unit } from '../../../nodes/kit/definition.ts';

/** Conversion of a stored number for display: radians to degrees; other units stay. */
export interface ShownUnit {
  readonly suffix: string;
  /** Factor from the stored to the displayed value. */
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
  /** Least value, in stored units; undefined if there is no limit. */
  readonly min: number | undefined;
  readonly max: number | undefined;
  readonly step: number;
}

/** Range and step of a param. The default step depends on the range. */
export function rangeOf(param: Pick<NumberParam, 'min' | 'max' | 'step' | 'unit'>): NumberRange {
  const { min, max } = param;
  if (param.step !== undefined) return { min, max, step: param.step };
  if (min === undefined || max === undefined || max <= min) return { min, max, step: 0.01 / shownUnit(param.unit).shownPerStored };
  // A power of ten that divides the range into 100 to 1,000 steps.
  return { min, max, step: 10 ** Math.floor(Math.log10((max - min) / 100)) };
}

export function clampTo(value: number, { min, max }: Pick<NumberRange, 'min' | 'max'>): number {
  return Math.min(Math.max(value, min ?? Number.NEGATIVE_INFINITY), max ?? Number.POSITIVE_INFINITY);
}

/** Formats a number with at most four decimals, or in exponential notation if it is very small or large. */
export function formatNumber(shown: number): string {
  const size = Math.abs(shown);
  if (size === 0) return '0';
  if (size < 1e-4 || size >= 1e7) return shown.toExponential(3);
  const text = shown.toFixed(4);
  return text.includes('.') ? text.replace(/\.?0+$/, '') || '0' : text;
}

/** Units that can be typed, as a factor to the stored unit. */
const TYPED: Readonly<Partial<Record<Unit, Readonly<Record<string, number>>>>> = {
  m: { mm: 0.001, cm: 0.01, dm: 0.1, m: 1, km: 1000, in: 0.0254, ft: 0.3048 },
  s: { ms: 0.001, s: 1, min: 60, h: 3600 },
  rad: { '°': Math.PI / 180, deg: Math.PI / 180, rad: 1, turn: 2 * Math.PI, turns: 2 * Math.PI },
  Hz: { Hz: 1, kHz: 1000 },
  ratio: { '%': 0.01 },
  none: { '%': 0.01 },
};

/** Factor from a typed unit to the stored unit; undefined for units of another quantity. */
export function storedPerTyped(typed: string, unit: Unit | undefined): number | undefined {
  if (typed === '') return 1 / shownUnit(unit).shownPerStored;
  return getOwn(TYPED[unit ?? 'none'] ?? {}, typed) ?? (typed === shownUnit(unit).suffix ? 1 : undefined);
}

/** Parses a typed number with an optional unit into stored units; null if invalid. Accepts a decimal comma. */
export function parseNumber(text: string, unit: Unit | undefined): number | null {
  const [, number, typed = ''] = /^([-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:e[-+]?\d+)?)\s*(\S*)$/i.exec(text.trim()) ?? [];
  const factor = number === undefined ? undefined : storedPerTyped(typed, unit);
  if (number === undefined || factor === undefined) return null;
  const value = Number(number.replace(',', '.')) * factor;
  return Number.isFinite(value) ? value : null;
}
