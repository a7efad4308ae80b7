import type { Expression, IfStatement, Statement } from '../syntax/ast.ts';

/**
 * Decides branches that depend on `PASSINDEX`. Branches of `if (PASSINDEX == 1) … else …` that a pass cannot take are left out of its text,
 * so that each pass refers only to images that it reads, which affects the order of passes, and drivers compile less.
 */
export function decideBranch(statement: IfStatement, passIndex: number): Statement | null | undefined {
  const value = evaluate(statement.condition, passIndex);
  if (value === null) return undefined;
  return value === 0 ? (statement.otherwise?.statement ?? null) : statement.then;
}

/**
 * The statements of a block that a pass can reach: none after an `if` that depends on `PASSINDEX` and leaves the function, as in `if
 * (PASSINDEX == 0) return first(); return second();`.
 */
export function reachableStatements(statements: readonly Statement[], passIndex: number): readonly Statement[] {
  const end = statements.findIndex((statement) => statement.kind === 'if' && leaves(decideBranch(statement, passIndex), passIndex));
  return end < 0 ? statements : statements.slice(0, end + 1);
}

function leaves(statement: Statement | null | undefined, passIndex: number): boolean {
  if (statement === null || statement === undefined) return false;
  if (statement.kind === 'block') return statement.statements.some((inner) => leaves(inner, passIndex));
  if (statement.kind === 'if') return leaves(decideBranch(statement, passIndex), passIndex);
  return statement.kind === 'return' || (statement.kind === 'jump' && statement.word === 'discard');
}

/** The value of an expression of `PASSINDEX` and literals, or of `&&` and `||` if one side decides it; else null. */
export function evaluate(expression: Expression, passIndex: number): number | null {
  switch (expression.kind) {
    case 'group':
      return evaluate(expression.inner, passIndex);
    case 'literal':
      return literalValue(expression.token.text);
    case 'name':
      return expression.symbol?.role === 'builtin' && expression.symbol.name === 'PASSINDEX' ? passIndex : null;
    case 'call': {
      const [arg] = expression.args;
      const isCast = expression.symbol === null && (expression.token.text === 'int' || expression.token.text === 'float');
      return isCast && arg !== undefined && expression.args.length === 1 ? evaluate(arg, passIndex) : null;
    }
    case 'prefix': {
      const value = evaluate(expression.operand, passIndex);
      if (value === null) return null;
      if (expression.token.text === '!') return value === 0 ? 1 : 0;
      return expression.token.text === '-' ? -value : null;
    }
    case 'binary':
      return evaluateBinary(expression, passIndex);
    default:
      return null;
  }
}

function evaluateBinary(expression: Extract<Expression, { kind: 'binary' }>, passIndex: number): number | null {
  const a = evaluate(expression.left, passIndex);
  const b = evaluate(expression.right, passIndex);
  switch (expression.token.text) {
    case '&&':
      if (a === 0 || b === 0) return 0;
      return a === null || b === null ? null : 1;
    case '||':
      if ((a ?? 0) !== 0 || (b ?? 0) !== 0) return 1;
      return a === null || b === null ? null : 0;
    default:
      return a === null || b === null ? null : compare(expression.token.text, a, b);
  }
}

function compare(operator: string, a: number, b: number): number | null {
  switch (operator) {
    case '==':
      return Number(a === b);
    case '!=':
      return Number(a !== b);
    case '<':
      return Number(a < b);
    case '>':
      return Number(a > b);
    case '<=':
      return Number(a <= b);
    case '>=':
      return Number(a >= b);
    default:
      return null;
  }
}

function literalValue(text: string): number | null {
  if (text === 'true') return 1;
  if (text === 'false') return 0;
  const value = Number(text.replace(/[uUfF]$|lf$|LF$/, ''));
  return Number.isFinite(value) ? value : null;
}
