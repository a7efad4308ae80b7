import type { Declarator, VariableDeclaration } from './ast.ts';
import type { Cursor } from './cursor.ts';
import { parseAssignment, parseDimensions } from './parse-expression.ts';
import { parseType } from './parse-type.ts';
import type { Token } from './token.ts';
import { DROPPED_QUALIFIERS, KEYWORDS, QUALIFIERS, TYPES } from './words.ts';

/** Whether a declaration begins here rather than an expression: a qualifier, or a type before a name. */
export function atDeclaration(cursor: Cursor): boolean {
  const token = cursor.peek();
  if (token.kind !== 'word') return false;
  if (token.text === 'struct' || atQualifier(cursor)) return true;
  const after = cursor.peek(1);
  if (TYPES.has(token.text)) return after.text !== '(' && !isArrayOf(cursor, '(');
  if (KEYWORDS.has(token.text)) return false;
  return (after.kind === 'word' && !KEYWORDS.has(after.text)) || isArrayOf(cursor, 'name');
}

/** Takes qualifiers, and keeps those that matter; a `layout(…)` goes too. */
export function parseQualifiers(cursor: Cursor): Token[] {
  const qualifiers: Token[] = [];
  while (atQualifier(cursor)) {
    const token = cursor.next();
    if (token.text === 'layout') {
      cursor.expect('(', 'after "layout"');
      while (!cursor.accept(')')) {
        if (cursor.peek().kind === 'end') throw cursor.unexpected('")" is missing after "layout("');
        cursor.next();
      }
    } else if (!DROPPED_QUALIFIERS.has(token.text)) {
      qualifiers.push(token);
    }
  }
  return qualifiers;
}

/** From the qualifiers up to, and without, the semicolon. */
export function parseVariables(cursor: Cursor): VariableDeclaration {
  const start = cursor.peek();
  const qualifiers = parseQualifiers(cursor);
  const type = parseType(cursor);
  return { kind: 'variables', start, qualifiers, type, declarators: parseDeclarators(cursor, type.struct !== null) };
}

/** `a = 1.0, b[2]`; none at all after a struct. */
export function parseDeclarators(cursor: Cursor, mayBeEmpty: boolean): Declarator[] {
  const declarators: Declarator[] = [];
  if (mayBeEmpty && cursor.at(';')) return declarators;
  do {
    const name = cursor.name('the variable');
    const dimensions = parseDimensions(cursor);
    const initializer = cursor.accept('=') ? parseAssignment(cursor) : null;
    declarators.push({ name, dimensions, initializer, symbol: null });
  } while (cursor.accept(','));
  return declarators;
}

/** Words such as `flat` and `smooth` are names in older GLSL: they qualify only what another word follows. */
function atQualifier(cursor: Cursor): boolean {
  const token = cursor.peek();
  if (!QUALIFIERS.has(token.text)) return false;
  if (KEYWORDS.has(token.text)) return true;
  const after = cursor.peek(1);
  return token.text === 'layout' ? after.text === '(' : after.kind === 'word';
}

/** `Type[…] name` or `Type[…](`. */
function isArrayOf(cursor: Cursor, wanted: 'name' | '('): boolean {
  if (cursor.peek(1).text !== '[') return false;
  let depth = 0;
  for (let ahead = 1; ; ahead += 1) {
    const token = cursor.peek(ahead);
    if (token.kind === 'end' || token.text === ';') return false;
    if (token.text === '[') depth += 1;
    if (token.text === ']') depth -= 1;
    const after = cursor.peek(ahead + 1);
    if (depth === 0 && after.text !== '[') return wanted === '(' ? after.text === '(' : after.kind === 'word';
  }
}
