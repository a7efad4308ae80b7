import { numericOf } from '../check/glsl-type.ts';
import type { Block, Expression, GlslType, Statement, VariableDeclaration } from '../syntax/ast.ts';
import type { Token } from '../syntax/token.ts';
import { decideBranch, reachableStatements } from './pass-condition.ts';
import { spend } from './prelude.ts';
import type { PrintContext } from './print-context.ts';
import { printVariables } from './print-declaration.ts';
import { printExpression } from './print-expression.ts';

/** Maximum nesting of structs, ANGLE's limit. */
const MAX_STRUCTS = 4;

/** Prints one statement on a new line. */
function printStatement(statement: Statement, context: PrintContext): void {
  const { writer } = context;
  writer.endLine();
  switch (statement.kind) {
    case 'block':
      writer.write('', statement.start);
      printBlock(statement, context);
      return;
    case 'variables':
      printVariables(statement, context);
      writer.write(';');
      break;
    case 'expression':
      printExpressions(statement.expression, context);
      break;
    case 'empty':
      writer.write(';', statement.start);
      break;
    case 'if':
      printIf(statement, context);
      return;
    case 'for':
      writer.write('for (', statement.start);
      printHead(statement.initial, context);
      writer.write('; ');
      printCondition(statement, context);
      writer.write('; ');
      printHead(statement.step, context);
      writer.write(')');
      printBody(statement.body, context);
      return;
    case 'while':
      writer.write('while (', statement.start);
      printCondition(statement, context);
      writer.write(')');
      printBody(statement.body, context);
      return;
    case 'do':
      writer.write('do', statement.start);
      printBody(statement.body, context);
      writer.write('while (', statement.end);
      printCondition(statement, context);
      writer.write(');');
      break;
    case 'switch':
      writer.write('switch (', statement.start);
      printExpression(statement.value, context);
      writer.write(') ');
      // Older GLSL allows a last label without statement.
      printBlock(statement.body, context, statement.body.statements.at(-1)?.kind === 'case' ? () => 'break;' : undefined);
      return;
    case 'case':
      writer.write(statement.value === null ? 'default' : 'case ', statement.start);
      if (statement.value !== null) printExpression(statement.value, context);
      writer.write(':');
      break;
    case 'return':
      context.found.returns = true;
      writer.write('return', statement.start);
      if (statement.value !== null) {
        writer.write(' ');
        printExpression(statement.value, context);
      }
      writer.write(';');
      break;
    case 'jump':
      printJump(statement, context);
      break;
    default:
      statement satisfies never;
  }
  writer.endLine();
}

/** Prints an expression statement. In WebGL, void expressions cannot be operands of a comma: `f(), g();` is printed as two statements. */
function printExpressions(expression: Expression, context: PrintContext): void {
  if (expression.kind === 'binary' && expression.token.text === ',') {
    printExpressions(expression.left, context);
    context.writer.endLine();
    printExpressions(expression.right, context);
    return;
  }
  printExpression(expression, context);
  context.writer.write(';');
}

/** Prints a block, continuing the current line. `ending` returns a last statement of the linker. */
export function printBlock(block: Block, context: PrintContext, ending?: () => string): void {
  const { writer } = context;
  writer.write('{');
  writer.indent(1);
  for (const statement of reachableStatements(block.statements, context.passIndex)) printStatement(statement, context);
  const last = ending?.() ?? '';
  if (last !== '') writer.own(last);
  writer.indent(-1);
  writer.write('}', block.end);
  writer.endLine();
}

/** Prints a body in braces, because it may become several statements. */
function printBody(body: Statement, context: PrintContext): void {
  const { writer } = context;
  writer.write(' ');
  if (body.kind === 'block') {
    printBlock(body, context);
    return;
  }
  writer.write('{');
  writer.indent(1);
  printStatement(body, context);
  writer.indent(-1);
  writer.own('}');
}

function printIf(first: Extract<Statement, { kind: 'if' }>, context: PrintContext): void {
  const { writer } = context;
  const branch = decideBranch(first, context.passIndex);
  if (branch !== undefined) {
    if (branch !== null) printTaken(branch, context);
    return;
  }
  writer.write('if (', first.start);
  printExpression(first.condition, context);
  writer.write(')');
  printBody(first.then, context);
  if (first.otherwise === null) return;
  const { start, statement } = first.otherwise;
  if (statement.kind === 'if' && decideBranch(statement, context.passIndex) === undefined) {
    writer.write('else ', start);
    printIf(statement, context);
  } else {
    writer.write('else', start);
    printBody(statement, context);
  }
}

/** Prints the branch of an `if` that a pass always takes. The branch keeps its braces, which limit the scope of its names. */
function printTaken(branch: Statement, context: PrintContext): void {
  if (branch.kind === 'block') {
    printStatement(branch, context);
    return;
  }
  context.writer.own('{');
  context.writer.indent(1);
  printStatement(branch, context);
  context.writer.indent(-1);
  context.writer.own('}');
}

function printHead(head: Expression | VariableDeclaration | null, context: PrintContext): void {
  if (head === null) return;
  if (head.kind === 'variables') printVariables(head, context);
  else printExpression(head, context);
}

/** Prints the condition of a loop. With a loop budget, the condition first counts the iteration; see `prelude.ts`. */
function printCondition({ start, condition }: Extract<Statement, { kind: 'for' | 'while' | 'do' }>, context: PrintContext): void {
  const { writer } = context;
  if (!context.loopBudget) {
    printHead(condition, context);
    return;
  }
  const pay = spend(start.line);
  if (condition === null) {
    writer.write(pay);
  } else if (condition.kind === 'variables') {
    printVariables(condition, context, `${pay} && `);
  } else {
    writer.write(`${pay} && (`);
    printExpression(condition, context);
    writer.write(')');
  }
}

/**
 * Prints a jump, such as `return`. `discard` would keep the previous content of the target, which is undefined here, so it is printed with
 * the meaning “transparent”: the function returns, the rest of the invocation has no effect, and the pixel becomes transparent.
 */
function printJump(statement: { readonly start: Token; readonly word: string }, context: PrintContext): void {
  const { writer, returnType } = context;
  if (statement.word !== 'discard') {
    writer.write(`${statement.word};`, statement.start);
    return;
  }
  const zero = returnType === 'void' ? '' : zeroOf(returnType, context);
  if (zero === null) {
    writer.write('discard;', statement.start);
    return;
  }
  context.found.discards = true;
  context.found.returns = true;
  writer.write(`{ scrim_discarded = true; return${zero === '' ? '' : ` ${zero}`}; }`, statement.start);
}

/**
 * A value of the type with all numbers 0; null for arrays, whose size is not part of the type, and for unknown types and deeper structs.
 */
export function zeroOf(type: GlslType, context: PrintContext, left = MAX_STRUCTS): string | null {
  if (numericOf(type) !== null) return `${type}(0)`;
  const struct = context.structs.get(type);
  if (struct === undefined || left === 0) return null;
  const members: string[] = [];
  for (const member of struct.members.values()) {
    const zero = zeroOf(member, context, left - 1);
    if (zero === null) return null;
    members.push(zero);
  }
  return `${context.names.of(struct)}(${members.join(', ')})`;
}
