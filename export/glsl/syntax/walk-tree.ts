import type { Declarator, Expression, Statement, VariableDeclaration } from './ast.ts';

export interface Walk {
  /** Called for each expression before its parts; returns the parts to visit, or undefined for all. */
  expression?(expression: Expression): readonly Expression[] | undefined;
  /** Called for each statement before its parts; returns the parts to visit, or undefined for all. */
  statement?(statement: Statement): readonly (Statement | Expression)[] | undefined;
  /** Called for each variable, after its initializer. */
  declarator?(declarator: Declarator): void;
}

export function walkStatement(statement: Statement, walk: Walk): void {
  for (const part of walk.statement?.(statement) ?? statementParts(statement)) walkPart(part, walk);
  if (statement.kind === 'variables') for (const declarator of statement.declarators) walk.declarator?.(declarator);
}

export function walkExpression(expression: Expression, walk: Walk): void {
  for (const part of walk.expression?.(expression) ?? operands(expression)) walkExpression(part, walk);
}

/** Expressions directly in a declaration, including the sizes in its type. */
function expressionsOf(declaration: VariableDeclaration): Expression[] {
  const found: (Expression | null)[] = [...declaration.type.dimensions];
  for (const declarator of declaration.declarators) found.push(...declarator.dimensions, declarator.initializer);
  return found.filter((expression) => expression !== null);
}

/** The direct parts of a statement or an expression. */
export function partsOf(part: Statement | Expression): readonly (Statement | Expression)[] {
  return isStatement(part) ? statementParts(part) : operands(part);
}

function walkPart(part: Statement | Expression, walk: Walk): void {
  if (isStatement(part)) walkStatement(part, walk);
  else walkExpression(part, walk);
}

function isStatement(part: Statement | Expression): part is Statement {
  return !('token' in part);
}

function statementParts(statement: Statement): readonly (Statement | Expression)[] {
  switch (statement.kind) {
    case 'block':
      return statement.statements;
    case 'variables':
      return expressionsOf(statement);
    case 'expression':
      return [statement.expression];
    case 'if':
      return statement.otherwise === null
        ? [statement.condition, statement.then]
        : [statement.condition, statement.then, statement.otherwise.statement];
    case 'for':
      return [statement.initial, statement.condition, statement.step, statement.body].filter((part) => part !== null);
    case 'while':
      return [statement.condition, statement.body];
    case 'do':
      return [statement.body, statement.condition];
    case 'switch':
      return [statement.value, statement.body];
    case 'case':
    case 'return':
      return statement.value === null ? [] : [statement.value];
    case 'empty':
    case 'jump':
      return [];
  }
}

/** The direct operands of an expression. */
function operands(expression: Expression): readonly Expression[] {
  switch (expression.kind) {
    case 'name':
    case 'literal':
      return [];
    case 'group':
      return [expression.inner];
    case 'prefix':
    case 'postfix':
      return [expression.operand];
    case 'binary':
      return [expression.left, expression.right];
    case 'conditional':
      return [expression.condition, expression.then, expression.otherwise];
    case 'member':
    case 'length':
      return [expression.object];
    case 'index':
      return [expression.object, expression.index];
    case 'array':
      return [...expression.of.dimensions.filter((dimension) => dimension !== null), ...expression.args];
    case 'call':
      return expression.args;
  }
}
