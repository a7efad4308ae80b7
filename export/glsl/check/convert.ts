import type { Expression, GlslType } from '../syntax/ast.ts';
import { converts } from './glsl-type.ts';

/** Marks an expression for conversion to `to`, if desktop GLSL converts it implicitly. */
export function convert(expression: Expression, to: GlslType): void {
  if (!converts(expression.type, to)) return;
  // The literal is converted, because `-(1.0)` is more readable.
  const inner = innerLiteral(expression);
  if (inner === null) {
    expression.convertTo = to;
  } else {
    convert(inner, to);
    expression.type = to;
  }
}

/** Marks the variable of an assignment target such as `a`, `a.xy` or `a[1].b` as written, and sets the types on the way. */
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
