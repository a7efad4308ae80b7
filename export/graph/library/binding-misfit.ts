import { type ParamDefinition, paramWireType } from '../../../nodes/kit/definition.ts';
import { isEasing, OVERSHOOT } from '../../../nodes/kit/ease.ts';
import type { Binding, Track } from '../project.ts';
import { misfit } from './param-value.ts';

export interface BindingMisfit {
  readonly code: 'SCR018' | 'SCR019';
  /** The reason in words that follow the label of the param: “must be …”, “cannot follow …”. */
  readonly message: string;
}

const MAX_EXPRESSION_CHARACTERS = 10_000;

/**
 * Why the param cannot have this binding, or null if it can. Limits, assets and the text of expressions are not checked, because an
 * expression may be incomplete.
 *
 * @example
 * bindingMisfit(amount, { value: 'much' }); // { code: 'SCR018', message: 'must be a finite number, but is "much".' }
 */
export function bindingMisfit(param: ParamDefinition, binding: Binding): BindingMisfit | null {
  if ('value' in binding) return valueMisfit(param, binding.value);
  if (param.type === 'curve' || param.type === 'gradient')
    return { code: 'SCR019', message: `is a ${param.type} and can only be bound to a value.` };
  if (paramWireType(param) === undefined) {
    return { code: 'SCR019', message: 'is fixed while the project runs and can only be bound to a value.' };
  }
  if ('port' in binding) return valueMisfit(param, binding.port);
  if ('track' in binding) return trackMisfit(param, binding.track);
  if (param.type === 'text') return { code: 'SCR019', message: 'cannot follow an expression: it is a text, and expressions are numbers.' };
  if (binding.expression.trim() === '') return { code: 'SCR019', message: 'is bound to an empty expression.' };
  if (binding.expression.length <= MAX_EXPRESSION_CHARACTERS) return null;
  return { code: 'SCR019', message: `is bound to an expression of more than ${MAX_EXPRESSION_CHARACTERS} characters.` };
}

function valueMisfit(param: ParamDefinition, value: unknown): BindingMisfit | null {
  const wanted = misfit(param, value);
  return wanted === null ? null : { code: 'SCR018', message: `must be ${wanted}, but is ${shorten(JSON.stringify(value))}.` };
}

function trackMisfit(param: ParamDefinition, { keys }: Track): BindingMisfit | null {
  if (param.type === 'text' || param.type === 'toggle' || param.type === 'choice') {
    return { code: 'SCR019', message: 'cannot follow keyframes: its values cannot be interpolated.' };
  }
  if (keys.length === 0) return { code: 'SCR019', message: 'is bound to a track without keyframes.' };
  for (const [i, { timeS, value, easing }] of keys.entries()) {
    const wanted = misfit(param, value);
    if (wanted !== null) return { code: 'SCR018', message: `must be ${wanted} in keyframe ${i + 1}.` };
    if (!isEasing(easing)) {
      const message = `has an invalid easing in keyframe ${i + 1}. Use control points with x from 0 to 1 and y from ${-OVERSHOOT} to ${1 + OVERSHOOT}.`;
      return { code: 'SCR019', message };
    }
    const before = keys[i - 1];
    if (before && before.timeS >= timeS)
      return { code: 'SCR019', message: `has keyframe ${i + 1} at or before the time of the previous one.` };
  }
  return null;
}

function shorten(text: string): string {
  return text.length <= 60 ? text : `${text.slice(0, 60)}…`;
}
