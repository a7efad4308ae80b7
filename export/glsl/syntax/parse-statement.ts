import type { Block, Expression, ForStatement, IfStatement, Statement, VariableDeclaration } from './ast.ts';
import type { Cursor } from './cursor.ts';
import { atDeclaration, parseVariables } from './parse-declaration.ts';
import { parseExpression } from './parse-expression.ts';
import type { Token } from './token.ts';

export function parseBlock(cursor: Cursor): Block {
  const start = cursor.expect('{', 'to open the block');
  const statements: Statement[] = [];
  for (;;) {
    const end = cursor.accept('}');
    if (end !== null) return { kind: 'block', start, statements, end };
    if (cursor.peek().kind === 'end') throw cursor.unexpected(`"}" is missing to close the "{" of line ${start.line}`);
    statements.push(...parseStatement(cursor));
  }
}

/** Parses a statement; empty for a precision statement. */
function parseStatement(cursor: Cursor): Statement[] {
  return cursor.nested(() => {
    if (cursor.at('precision')) {
      skipPrecision(cursor);
      return [];
    }
    return [parseOne(cursor)];
  });
}

/** Skips `precision mediump float;`, because all printed text is highp. */
export function skipPrecision(cursor: Cursor): void {
  cursor.expect('precision', 'here');
  cursor.next();
  cursor.next();
  cursor.expect(';', 'after the precision');
}

function parseOne(cursor: Cursor): Statement {
  const start = cursor.peek();
  switch (start.text) {
    case '{':
      return parseBlock(cursor);
    case ';':
      return { kind: 'empty', start: cursor.next() };
    case 'if':
      return parseIf(cursor);
    case 'for':
      return parseFor(cursor);
    case 'while': {
      cursor.next();
      const condition = parseCondition(cursor, 'while');
      return { kind: 'while', start, condition, body: parseBody(cursor) };
    }
    case 'do': {
      cursor.next();
      const body = parseBody(cursor);
      const end = cursor.expect('while', 'after the body of "do"');
      cursor.expect('(', 'after "while"');
      const condition = parseExpression(cursor);
      cursor.expect(')', 'after the condition');
      cursor.expect(';', 'after "while (…)"');
      return { kind: 'do', start, body, end, condition };
    }
    case 'switch': {
      cursor.next();
      cursor.expect('(', 'after "switch"');
      const value = parseExpression(cursor);
      cursor.expect(')', 'after the value of "switch"');
      return { kind: 'switch', start, value, body: parseBlock(cursor) };
    }
    case 'case':
    case 'default': {
      cursor.next();
      const value = start.text === 'case' ? parseExpression(cursor) : null;
      cursor.expect(':', `after "${start.text}"`);
      return { kind: 'case', start, value };
    }
    case 'return': {
      cursor.next();
      const value = cursor.at(';') ? null : parseExpression(cursor);
      cursor.expect(';', 'after "return"');
      return { kind: 'return', start, value };
    }
    case 'break':
    case 'continue':
    case 'discard':
      cursor.next();
      cursor.expect(';', `after "${start.text}"`);
      return { kind: 'jump', start, word: start.text };
    default:
      return parseSimple(cursor);
  }
}

function parseSimple(cursor: Cursor): Statement {
  const statement: Statement = atDeclaration(cursor) ? parseVariables(cursor) : { kind: 'expression', expression: parseExpression(cursor) };
  cursor.expect(';', statement.kind === 'variables' ? 'after the declaration' : 'after the statement');
  return statement;
}

function parseIf(cursor: Cursor): IfStatement {
  const start = cursor.next();
  cursor.expect('(', 'after "if"');
  const condition = parseExpression(cursor);
  cursor.expect(')', 'after the condition');
  const then = parseBody(cursor);
  const otherwise = cursor.accept('else');
  return { kind: 'if', start, condition, then, otherwise: otherwise && { start: otherwise, statement: parseBody(cursor) } };
}

function parseFor(cursor: Cursor): ForStatement {
  const start = cursor.next();
  cursor.expect('(', 'after "for"');
  const initial = cursor.at(';') ? null : parseDeclarationOrExpression(cursor);
  cursor.expect(';', 'after the start of "for"');
  const condition = cursor.at(';') ? null : parseDeclarationOrExpression(cursor);
  cursor.expect(';', 'after the condition of "for"');
  const step = cursor.at(')') ? null : parseExpression(cursor);
  cursor.expect(')', 'after the step of "for"');
  return { kind: 'for', start, initial, condition, step, body: parseBody(cursor) };
}

function parseCondition(cursor: Cursor, word: string): Expression | VariableDeclaration {
  cursor.expect('(', `after "${word}"`);
  const condition = parseDeclarationOrExpression(cursor);
  cursor.expect(')', 'after the condition');
  return condition;
}

function parseDeclarationOrExpression(cursor: Cursor): Expression | VariableDeclaration {
  return atDeclaration(cursor) ? parseVariables(cursor) : parseExpression(cursor);
}

/** The statement of an `if` or a loop. */
function parseBody(cursor: Cursor): Statement {
  const start: Token = cursor.peek();
  const [statement] = parseStatement(cursor);
  return statement ?? { kind: 'empty', start };
}
