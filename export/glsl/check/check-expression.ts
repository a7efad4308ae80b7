import type { Dimension, Expression, GlslType, StructSymbol, TypeSpecifier } from '../syntax/ast.ts';
import { ASSIGNMENTS } from '../syntax/parse-expression.ts';
import { TYPES } from '../syntax/words.ts';
import { checkCall } from './check-call.ts';
import { convert, markWritten } from './convert.ts';
import { canonicalType, converts, elementType, floatLike, matrixType, numericOf, swizzleType, vectorType } from './glsl-type.ts';
import { type CheckContext, findStruct, findVariable } from './scope.ts';

/**
 * Sets symbols and types, and marks implicit conversions, which ES 3.00 does not have. An expression that cannot be typed has an empty
 * type; the driver reports the mistake.
 */
export function checkExpression(expression: Expression, context: CheckContext): GlslType {
  expression.type = typeOf(expression, context);
  return expression.type;
}

function typeOf(expression: Expression, context: CheckContext): GlslType {
  switch (expression.kind) {
    case 'literal':
      return expression.type;
    case 'name':
      expression.symbol = findVariable(context.scope, expression.token.text);
      return expression.symbol?.type ?? '';
    case 'group':
      return checkExpression(expression.inner, context);
    case 'prefix':
      return checkPrefix(expression, context);
    case 'postfix': {
      const type = checkExpression(expression.operand, context);
      markWritten(expression.operand);
      return type;
    }
    case 'binary':
      return checkBinary(expression, context);
    case 'conditional':
      return checkConditional(expression, context);
    case 'member':
      return memberType(checkExpression(expression.object, context), expression.name.text, context);
    case 'index':
      checkExpression(expression.index, context);
      return elementType(checkExpression(expression.object, context));
    case 'length':
      checkExpression(expression.object, context);
      return 'int';
    case 'array':
      return checkArray(expression.of, expression.args, context);
    case 'call':
      for (const arg of expression.args) checkExpression(arg, context);
      return checkCall(expression, context);
  }
}

function checkPrefix(expression: Extract<Expression, { kind: 'prefix' }>, context: CheckContext): GlslType {
  const type = checkExpression(expression.operand, context);
  if (expression.token.text === '++' || expression.token.text === '--') markWritten(expression.operand);
  return type;
}

function checkBinary(expression: Extract<Expression, { kind: 'binary' }>, context: CheckContext): GlslType {
  const left = checkExpression(expression.left, context);
  const right = checkExpression(expression.right, context);
  const operator = expression.token.text;
  if (ASSIGNMENTS.has(operator)) {
    markWritten(expression.left);
    if (operator === '=') convert(expression.right, left);
    else unifyBases(expression.right, left);
    return left;
  }
  switch (operator) {
    case ',':
      return right;
    case '&&':
    case '||':
    case '^^':
      return 'bool';
    case '==':
    case '!=':
    case '<':
    case '>':
    case '<=':
    case '>=':
      unifyOperands(expression.left, expression.right);
      return 'bool';
    case '<<':
    case '>>':
      return left;
    default:
      unifyOperands(expression.left, expression.right);
      return arithmeticType(operator, printedType(expression.left), printedType(expression.right));
  }
}

function checkConditional(expression: Extract<Expression, { kind: 'conditional' }>, context: CheckContext): GlslType {
  checkExpression(expression.condition, context);
  checkExpression(expression.then, context);
  checkExpression(expression.otherwise, context);
  unifyOperands(expression.then, expression.otherwise);
  const struct = context.structs.get(expression.then.type);
  if (struct !== undefined) struct.chosen = true;
  return printedType(expression.then) || printedType(expression.otherwise);
}

/** Converts the integer operand to float if the other one is float; sizes stay. */
function unifyOperands(a: Expression, b: Expression): void {
  unifyBases(a, b.type);
  unifyBases(b, a.type);
}

function unifyBases(expression: Expression, other: GlslType): void {
  if (numericOf(other)?.base === 'float') {
    const wanted = floatLike(expression.type);
    if (converts(expression.type, wanted)) convert(expression, wanted);
  } else if (numericOf(other)?.base === 'uint' && numericOf(expression.type)?.base === 'int') {
    convert(expression, vectorType('uint', numericOf(expression.type)?.rows ?? 1));
  }
}

function printedType(expression: Expression): GlslType {
  return expression.convertTo || expression.type;
}

/** Type of an arithmetic operation (GLSL ES 3.00 §5.9). */
function arithmeticType(operator: string, left: GlslType, right: GlslType): GlslType {
  const a = numericOf(left);
  const b = numericOf(right);
  if (a === null || b === null) return '';
  const aScalar = a.rows === 1 && a.columns === 1;
  const bScalar = b.rows === 1 && b.columns === 1;
  if (aScalar) return right;
  if (bScalar) return left;
  if (operator !== '*' || (a.columns === 1 && b.columns === 1)) return left;
  if (a.columns > 1 && b.columns > 1) return matrixType(b.columns, a.rows);
  return a.columns > 1 ? vectorType('float', a.rows) : vectorType('float', b.columns);
}

function memberType(type: GlslType, name: string, context: CheckContext): GlslType {
  return context.structs.get(type)?.members.get(name) ?? swizzleType(type, name);
}

function checkArray(of: TypeSpecifier, args: readonly Expression[], context: CheckContext): GlslType {
  resolveType(of, context);
  const element = of.type.replace(/\[\]$/, '');
  for (const arg of args) {
    checkExpression(arg, context);
    convert(arg, element);
  }
  return of.type;
}

/** Resolves a type, and declares the struct if it is defined there. */
export function resolveType(specifier: TypeSpecifier, context: CheckContext): GlslType {
  checkDimensions(specifier.dimensions, context);
  specifier.type = arrayType(baseType(specifier, context), specifier.dimensions);
  return specifier.type;
}

export function arrayType(element: GlslType, dimensions: readonly Dimension[]): GlslType {
  return element === '' ? '' : element + '[]'.repeat(dimensions.length);
}

function baseType(specifier: TypeSpecifier, context: CheckContext): GlslType {
  const { struct } = specifier;
  if (struct !== null) {
    const members = new Map<string, GlslType>();
    for (const member of struct.members) {
      checkDimensions(member.dimensions, context);
      members.set(member.name.text, arrayType(resolveType(member.type, context), member.dimensions));
    }
    const name = struct.name?.text ?? '';
    const symbol: StructSymbol = {
      kind: 'struct',
      name,
      type: `${name}#${context.structs.size}`,
      members,
      global: context.scope.parent?.parent === null,
      chosen: false,
    };
    context.structs.set(symbol.type, symbol);
    if (name !== '') context.scope.structs.set(name, symbol);
    struct.symbol = symbol;
    specifier.symbol = symbol;
    return symbol.type;
  }
  const name = specifier.name.text;
  if (TYPES.has(name)) return canonicalType(name);
  specifier.symbol = findStruct(context.scope, name);
  return specifier.symbol?.type ?? '';
}

export function checkDimensions(dimensions: readonly Dimension[], context: CheckContext): void {
  for (const dimension of dimensions) if (dimension !== null) checkExpression(dimension, context);
}
