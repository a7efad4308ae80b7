import { type ParamDefinition, paramWireType } from '../../../nodes/kit/definition.ts';
import { VALUE_SIZES } from '../../../nodes/kit/wire-types.ts';
import { type ParsedExpression, parseExpression } from './expression-parser.ts';

/**
 * Parses the expression that a param is bound to, with as many numbers as the param has.
 *
 * @example
 * parseBinding(amount, '1 + sin(time)'); // { ok: true, parts: ['1 time sin +'] } if `amount` is a number param
 */
export function parseBinding(param: ParamDefinition, expression: string): ParsedExpression {
  const type = paramWireType(param);
  return parseExpression(expression, type === undefined ? 1 : VALUE_SIZES[type]);
}

/**
 * Parses the value of a param that is itself an expression; returns null for other params.
 *
 * @example
 * parseValue(formula, 'sin(time)'); // { ok: true, parts: ['time sin'] } if `formula` is a text param with `expression`
 */
export function parseValue(param: ParamDefinition, value: unknown): ParsedExpression | null {
  if (param.type !== 'text' || !param.expression || typeof value !== 'string') return null;
  return parseExpression(value, 1, param.expression.names);
}
