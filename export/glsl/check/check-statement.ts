import type { Declarator, Expression, GlslType, Statement, VariableDeclaration, VariableSymbol } from '../syntax/ast.ts';
import { arrayType, checkDimensions, checkExpression, resolveType } from './check-expression.ts';
import { isConstant } from './constant.ts';
import { convert } from './convert.ts';
import { type CheckContext, createScope, findVariable } from './scope.ts';

export function checkStatements(statements: readonly Statement[], context: CheckContext): void {
  for (const statement of statements) checkStatement(statement, context);
}

/** Runs `check` in a new scope. */
export function inScope(context: CheckContext, sharesWithParent: boolean, check: () => void): void {
  const outer = context.scope;
  context.scope = createScope(outer, sharesWithParent);
  check();
  context.scope = outer;
}

function checkStatement(statement: Statement, context: CheckContext): void {
  switch (statement.kind) {
    case 'block':
      inScope(context, false, () => checkStatements(statement.statements, context));
      return;
    case 'variables':
      checkLocals(statement, context);
      return;
    case 'expression':
      checkExpression(statement.expression, context);
      return;
    case 'if':
      checkExpression(statement.condition, context);
      inScope(context, false, () => checkStatement(statement.then, context));
      if (statement.otherwise !== null) {
        const { statement: otherwise } = statement.otherwise;
        inScope(context, false, () => checkStatement(otherwise, context));
      }
      return;
    case 'for':
      inScope(context, false, () => {
        checkHead(statement.initial, context);
        checkHead(statement.condition, context);
        checkHead(statement.step, context);
        checkLoopBody(statement.body, context);
      });
      return;
    case 'while':
      inScope(context, false, () => {
        checkHead(statement.condition, context);
        checkLoopBody(statement.body, context);
      });
      return;
    case 'do':
      inScope(context, false, () => checkStatement(statement.body, context));
      checkExpression(statement.condition, context);
      return;
    case 'switch':
      checkExpression(statement.value, context);
      inScope(context, false, () => checkStatements(statement.body.statements, context));
      return;
    case 'case':
      checkHead(statement.value, context);
      return;
    case 'return':
      if (statement.value === null) return;
      checkExpression(statement.value, context);
      convert(statement.value, context.returnType);
      return;
    case 'empty':
    case 'jump':
      return;
    default:
      statement satisfies never;
  }
}

function checkHead(head: Expression | VariableDeclaration | null, context: CheckContext): void {
  if (head === null) return;
  if (head.kind === 'variables') checkLocals(head, context);
  else checkExpression(head, context);
}

/** Checks the body of a loop, which in ES 3.00 shares the scope of the loop's head. */
function checkLoopBody(body: Statement, context: CheckContext): void {
  inScope(context, true, () => {
    if (body.kind === 'block') checkStatements(body.statements, context);
    else checkStatement(body, context);
  });
}

function checkLocals(declaration: VariableDeclaration, context: CheckContext): void {
  resolveType(declaration.type, context);
  const isConst = declaration.qualifiers.some((qualifier) => qualifier.text === 'const');
  for (const declarator of declaration.declarators) {
    const type = checkDeclarator(declarator, declaration.type.type, context);
    declareLocal(declarator, type, isConst, context);
  }
}

/**
 * Checks sizes and initializer and returns the variable's type. The caller declares the name afterwards, because it is not visible in its
 * initializer.
 */
export function checkDeclarator(declarator: Declarator, element: GlslType, context: CheckContext): GlslType {
  checkDimensions(declarator.dimensions, context);
  const type = arrayType(element, declarator.dimensions);
  if (declarator.initializer !== null) {
    checkExpression(declarator.initializer, context);
    convert(declarator.initializer, type);
  }
  return type;
}

function declareLocal(declarator: Declarator, type: GlslType, isConst: boolean, context: CheckContext): void {
  const name = declarator.name.text;
  const { scope } = context;
  const clashes = scope.sharesWithParent && scope.parent?.variables.has(name) === true && !scope.variables.has(name);
  const symbol: VariableSymbol = {
    kind: 'variable',
    name,
    type,
    role: 'local',
    token: declarator.name,
    constant: isConst && declarator.initializer !== null && isConstant(declarator.initializer),
    rename: clashes || findVariable(scope, name)?.rename === true,
    written: false,
    declaration: declarator,
    parameterOf: null,
  };
  scope.variables.set(name, symbol);
  declarator.symbol = symbol;
}
