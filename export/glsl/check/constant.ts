import type { Expression } from '../syntax/ast.ts';
import { ASSIGNMENTS } from '../syntax/parse-expression.ts';
import { isBuiltinFunction, TEXTURE_FUNCTIONS } from './builtin-functions.ts';
import { numericOf } from './glsl-type.ts';

/** Whether an expression is a constant expression by GLSL ES 3.00 §4.3.3. */
export function isConstant(expression: Expression): boolean {
  switch (expression.kind) {
    case 'literal':
      return true;
    case 'name':
      return expression.symbol?.constant ?? false;
    case 'group':
      return isConstant(expression.inner);
    case 'prefix':
      return expression.token.text !== '++' && expression.token.text !== '--' && isConstant(expression.operand);
    case 'postfix':
      return false;
    case 'binary':
      return (
        !ASSIGNMENTS.has(expression.token.text) &&
        expression.token.text !== ',' &&
        isConstant(expression.left) &&
        isConstant(expression.right)
      );
    case 'conditional':
      // Equality of structs is printed as a call.
      return (
        !expression.type.includes('#') &&
        isConstant(expression.condition) &&
        isConstant(expression.then) &&
        isConstant(expression.otherwise)
      );
    case 'member':
    case 'length':
      return isConstant(expression.object);
    case 'index':
      return isConstant(expression.object) && isConstant(expression.index);
    case 'array':
      return expression.args.every(isConstant);
    case 'call':
      return isConstantCallee(expression) && expression.args.every(isConstant);
  }
}

function isConstantCallee(call: Extract<Expression, { kind: 'call' }>): boolean {
  if (call.symbol !== null) return call.symbol.kind === 'struct';
  const name = call.token.text;
  return numericOf(name) !== null || (isBuiltinFunction(name) && !TEXTURE_FUNCTIONS.has(name));
}
