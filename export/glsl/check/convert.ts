import type { Expression, GlslType } from '../syntax/ast.ts';
import { converts } from './glsl-type.ts';

/** Marks an expression to be printed as `to`, if desktop GLSL would convert it there by itself. */
export function convert(expression: Expression, to: GlslType): void {
  if (!converts(expression.type, to)) return;
  // `-(1)` becomes `-(1.0)`: a literal takes the conversion itself, which reads best.
  const inner = innerLiteral(expression);
  if (inner === null) {
    expression.convertTo = to;
  } else {
    convert(inner, to);
    expression.type = to;
  }
}

/** The variable that `a`, `a.xy` or `a[1].b` is part of is written to; its type is found on the way. */
export function markWritten(target: Expression): void {
  let at = target;
  while (at.kind === 'member' || at.kind === 'index' || at.kind === 'group') at = at.kind === 'group' ? at.inner : at.object;
  if (at.kind === 'name' && at.symbol !== null) at.symbol.written = true;
}

function innerLiteral(expression: Expression): Expression | null {
  if (expression.kind === 'group') return expression.inner;
  if (expression.kind !== 'prefix' || expression.token.text !== '-') return null;
  return expression.operand.kind === 'literal' || innerLiteral(expression.operand) !== null ? expression.operand : null;
}
