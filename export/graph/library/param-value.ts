import { curveMisfit } from '../../../nodes/kit/curve.ts';
import type { ParamDefinition, ParamValue } from '../../../nodes/kit/definition.ts';
import { gradientMisfit } from '../../../nodes/kit/gradient.ts';
import { VALUE_SIZES } from '../../../nodes/kit/wire-types.ts';
import { MAX_NUMBER } from '../json/shape-reader.ts';
import type { Binding } from '../project.ts';

/**
 * @returns The value of a binding, or undefined for a track or an expression.
 *
 * @example
 * boundValue({ value: 0.5 }); // 0.5
 * boundValue({ expression: 'sin(time)' }); // undefined
 */
export function boundValue(binding: Binding): ParamValue | undefined {
  if ('value' in binding) return binding.value;
  return 'port' in binding ? binding.port : undefined;
}

export function sameValue(a: ParamValue, b: ParamValue): boolean {
  if (typeof a !== 'object' || typeof b !== 'object') return a === b;
  return a.length === b.length && a.every((number, i) => number === b[i]);
}

/** What `value` must be to fit `param`, in words, or null if it fits. Limits are checked by `outOfRange`. */
export function misfit(param: ParamDefinition, value: unknown): string | null {
  switch (param.type) {
    case 'number':
      return isNumber(value) ? null : 'a finite number';
    case 'vector2':
    case 'vector3':
    case 'vector4':
    case 'color': {
      const size = VALUE_SIZES[param.type];
      return Array.isArray(value) && value.length === size && value.every(isNumber) ? null : `a list of ${size} finite numbers`;
    }
    case 'toggle':
      return typeof value === 'boolean' ? null : 'true or false';
    case 'text':
      return typeof value === 'string' ? null : 'a text';
    case 'choice':
      if (param.options.some((option) => option.value === value)) return null;
      return `one of ${param.options.map(({ value: is, label }) => `${JSON.stringify(is)} (${label})`).join(', ')}`;
    case 'curve':
      return curveMisfit(value);
    case 'gradient':
      return gradientMisfit(value);
    case 'asset':
      return typeof value === 'string' ? null : 'the id of an asset';
  }
}

/**
 * The limits that a valid value exceeds, in words, or null.
 *
 * @example
 * outOfRange(amount, 2); // 'from 0 to 1' for a number param with these limits
 * outOfRange(amount, 0.5); // null
 */
export function outOfRange(param: ParamDefinition, value: ParamValue): string | null {
  if (sameValue(clampToRange(param, value), value)) return null;
  switch (param.type) {
    case 'number':
      if (param.min === undefined) return `at most ${param.max}`;
      return param.max === undefined ? `at least ${param.min}` : `from ${param.min} to ${param.max}`;
    case 'vector2':
    case 'vector3':
    case 'vector4':
      return `from ${listOf(param.min)} to ${listOf(param.max)}`;
    case 'color':
      return 'from 0 to 1 in each channel';
    case 'toggle':
    case 'text':
    case 'choice':
    case 'curve':
    case 'gradient':
    case 'asset':
      throw new Error(`A ${param.type} has no limits.`);
  }
}

/**
 * @returns The nearest value within the limits of the param.
 *
 * @example
 * clampToRange(amount, 2); // 1 for a number param from 0 to 1
 */
export function clampToRange(param: ParamDefinition, value: ParamValue): ParamValue {
  switch (param.type) {
    case 'number':
      return typeof value === 'number' ? clamp(value, param.min, param.max) : value;
    case 'vector2':
    case 'vector3':
    case 'vector4':
      return typeof value === 'object' ? value.map((component, i) => clamp(component, param.min?.[i], param.max?.[i])) : value;
    case 'color':
      return typeof value === 'object' ? value.map((channel) => clamp(channel, 0, 1)) : value;
    case 'toggle':
    case 'text':
    case 'choice':
    case 'curve':
    case 'gradient':
    case 'asset':
      return value;
  }
}

/** Converts −0 to 0, because JSON cannot represent −0. */
export function withoutNegativeZero(value: ParamValue): ParamValue {
  if (typeof value === 'number') return value + 0;
  return typeof value === 'object' ? value.map((number) => number + 0) : value;
}

function isNumber(value: unknown): value is number {
  return typeof value === 'number' && Math.abs(value) <= MAX_NUMBER;
}

function clamp(value: number, min = Number.NEGATIVE_INFINITY, max = Number.POSITIVE_INFINITY): number {
  return Math.min(Math.max(value, min), max);
}

function listOf(limits: readonly number[] | undefined): string {
  return limits === undefined ? 'anything' : `[${limits.join(', ')}]`;
}
