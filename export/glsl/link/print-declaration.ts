import { isConstant } from '../check/constant.ts';
import { isImageType, numericOf } from '../check/glsl-type.ts';
import type {
  Declarator,
  FunctionDeclaration,
  Parameter,
  StructDeclaration,
  TypeSpecifier,
  VariableDeclaration,
  VariableSymbol,
} from '../syntax/ast.ts';
import { ASSIGNMENT } from './line-writer.ts';
import type { PrintContext } from './print-context.ts';
import { CHOOSE, printDimensions, printExpression, printTypeName } from './print-expression.ts';
import type { Instance } from './reach.ts';

/**
 * Prints a local declaration without its semicolon. ES 3.00 requires constant initializers of `const`; for others the qualifier is dropped.
 * `guard` is printed before the value, which is then in brackets.
 */
export function printVariables(declaration: VariableDeclaration, context: PrintContext, guard = ''): void {
  const { writer } = context;
  const constant = declaration.declarators.every((declarator) => declarator.symbol?.constant === true);
  for (const qualifier of declaration.qualifiers) {
    if (qualifier.text !== 'const' || constant) writer.write(`${qualifier.text} `, qualifier);
  }
  printType(declaration.type, context);
  declaration.declarators.forEach((declarator, i) => {
    writer.write(i === 0 ? ' ' : ', ');
    printDeclarator(declarator, context, guard);
  });
}

/** Prints global variables, one per statement, with a struct that is declared there. */
export function printGlobals(declaration: VariableDeclaration, context: PrintContext): void {
  const { writer } = context;
  const { struct } = declaration.type;
  if (struct !== null) {
    printStruct(struct, context);
    writer.write(';');
    writer.endLine();
    if (struct.symbol?.chosen === true) writer.own(choiceText(context.names.of(struct.symbol)));
  }
  for (const declarator of declaration.declarators) {
    const { symbol } = declarator;
    if (symbol === null || !context.reach.globals.has(symbol)) continue;
    if (symbol.role === 'varying') printVaryingQualifiers(symbol, context);
    else printGlobalQualifiers(declaration, declarator, symbol, context);
    if (needsHoisting(declarator)) {
      const length = declarator.initializer?.kind === 'array' ? declarator.initializer.args.length : null;
      printTypeName(declaration.type, context, length);
      writer.write(' ');
      writer.write(context.names.of(symbol), declarator.name);
      printDimensions(declarator.dimensions, context, length);
    } else {
      printTypeName(declaration.type, context);
      writer.write(' ');
      printDeclarator(declarator, context);
    }
    writer.write(';');
    writer.endLine();
  }
}

/** Prints the function that replaces `? :` between two values of a struct type (`CHOOSE`). */
export function choiceText(type: string): string {
  return `${type} ${CHOOSE}(const in bool first, const in ${type} a, const in ${type} b) {\n  if (first) return a;\n  return b;\n}`;
}

function printGlobalQualifiers(
  { qualifiers }: VariableDeclaration,
  { initializer }: Declarator,
  { constant }: VariableSymbol,
  { writer }: PrintContext,
): void {
  for (const qualifier of qualifiers) {
    // A `uniform` with an initializer, which desktop GLSL allows, becomes a variable.
    const stays = qualifier.text === 'uniform' ? initializer === null : qualifier.text !== 'const' || constant;
    if (stays) writer.write(`${qualifier.text} `, qualifier);
  }
}

/** Prints `in` or `out` before a varying, with `flat` for integers, which are not interpolated (GLSL ES 3.00 §4.3.6). */
function printVaryingQualifiers({ name, type }: VariableSymbol, { writer, stage, varyings }: PrintContext): void {
  if (!varyings.has(name)) return;
  const { base } = numericOf(type.replaceAll('[]', '')) ?? { base: 'float' };
  writer.write(`${base === 'int' || base === 'uint' ? 'flat ' : ''}${stage === 'vertex' ? 'out' : 'in'} `);
}

/**
 * Whether the initializer of a global variable must be assigned at the start of `main`: ES 3.00 allows only constant initializers of
 * globals.
 */
export function needsHoisting(declarator: Declarator): boolean {
  return declarator.initializer !== null && !isConstant(declarator.initializer);
}

export function printHoisted(declarator: Declarator, context: PrintContext): void {
  const { writer } = context;
  if (declarator.symbol === null || declarator.initializer === null) return;
  writer.write(`${context.names.of(declarator.symbol)} = `, declarator.name);
  printExpression(declarator.initializer, context);
  writer.write(';');
  writer.endLine();
}

/** Prints the head of a function. */
export function printFunctionHead(declaration: FunctionDeclaration, instance: Instance, context: PrintContext): void {
  const { writer } = context;
  printTypeName(declaration.returnType, context);
  writer.write(' ');
  writer.write(`${instance.name}(`, declaration.name);
  // Parameters of a prototype have no symbols; images are recognized by type.
  const values = declaration.parameters.filter((parameter) => !isImageType(parameter.type.type));
  values.forEach((parameter, i) => {
    if (i > 0) writer.write(', ');
    printParameter(parameter, context);
  });
  writer.write(')');
}

function printParameter(parameter: Parameter, context: PrintContext): void {
  const { writer, names } = context;
  // ES 3.00 requires `const` before `in`; desktop GLSL allows both orders.
  const constFirst = [...parameter.qualifiers].sort((a, b) => Number(b.text === 'const') - Number(a.text === 'const'));
  for (const qualifier of constFirst) writer.write(`${qualifier.text} `, qualifier);
  printTypeName(parameter.type, context);
  // Parameters of a prototype have no symbols and need no names.
  if (parameter.name !== null && parameter.symbol !== null) {
    writer.write(' ');
    writer.write(names.of(parameter.symbol), parameter.name);
  }
  printDimensions(parameter.dimensions, context);
}

function printType(type: TypeSpecifier, context: PrintContext): void {
  if (type.struct === null) {
    printTypeName(type, context);
    return;
  }
  printStruct(type.struct, context);
  printDimensions(type.dimensions, context);
}

function printStruct(struct: StructDeclaration, context: PrintContext): void {
  const { writer, names } = context;
  writer.write('struct ', struct.start);
  if (struct.symbol !== null) writer.write(names.of(struct.symbol));
  writer.write(' {');
  writer.indent(1);
  for (const member of struct.members) {
    printType(member.type, context);
    writer.write(' ');
    writer.write(names.member(member.name.text), member.name);
    printDimensions(member.dimensions, context);
    writer.write(';');
    writer.endLine();
  }
  writer.indent(-1);
  writer.write('}');
}

function printDeclarator(declarator: Declarator, context: PrintContext, guard = ''): void {
  const { writer, names } = context;
  const { equals, initializer } = declarator;
  // Drivers report mistakes of the value at the name.
  const quoted = equals === null ? undefined : ASSIGNMENT;
  writer.write(declarator.symbol === null ? declarator.name.text : names.of(declarator.symbol), declarator.name, quoted);
  printDimensions(declarator.dimensions, context);
  if (equals === null || initializer === null) return;
  writer.write(' = ', equals);
  if (guard !== '') writer.write(`${guard}(`);
  printExpression(initializer, context);
  if (guard !== '') writer.write(')');
}
