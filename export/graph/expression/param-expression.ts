import { type ParamDefinition, paramWireType } from '../../../nodes/kit/definition.ts';
import { VALUE_SIZES } from '../../../nodes/kit/wire-types.ts';
import { type ParsedExpression, parseExpression } from './expression-parser.ts';

/** Parses the expression that a param is bound to, with as many numbers as the param has. */
export function parseBinding(param: ParamDefinition, expression: string): ParsedExpression {
  const type = paramWireType(param);
  return parseExpression(expression, type === undefined ? 1 : VALUE_SIZES[type]);
}

/** Parses the value of a param that is itself an expression; returns null for other params. */
export function parseValue(param: ParamDefinition, value: unknown): ParsedExpression | null {
  if (param.type !== 'text' || !param.expression || typeof value !== 'string') return null;
  return parseExpression(value, 1, param.expression.names);
}
