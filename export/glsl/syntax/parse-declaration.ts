import type { Declarator, Dimension, Expression, TypeSpecifier, VariableDeclaration } from './ast.ts';
import type { Cursor } from './cursor.ts';
import { constructorOf, parseAssignment, parseDimensions } from './parse-expression.ts';
import { parseType } from './parse-type.ts';
import { GlslError, type Token } from './token.ts';
import { DROPPED_QUALIFIERS, KEYWORDS, QUALIFIERS, TYPES } from './words.ts';

/** Whether a declaration starts here: a qualifier, or a type before a name. */
export function atDeclaration(cursor: Cursor): boolean {
  const token = cursor.peek();
  if (token.kind !== 'word') return false;
  if (token.text === 'struct' || atQualifier(cursor)) return true;
  const after = cursor.peek(1);
  if (TYPES.has(token.text)) return after.text !== '(' && !isArrayOf(cursor, '(');
  if (KEYWORDS.has(token.text)) return false;
  return (after.kind === 'word' && !KEYWORDS.has(after.text)) || isArrayOf(cursor, 'name');
}

/** Consumes qualifiers and returns those with an effect; also consumes `layout(…)`. */
export function parseQualifiers(cursor: Cursor): Token[] {
  const qualifiers: Token[] = [];
  while (atQualifier(cursor)) {
    const token = cursor.next();
    if (token.text === 'noperspective') throw new GlslError(token, '"noperspective" is not in WebGL 2: leave it out.', 'SCR043');
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

/** Parses a declaration of variables, from its qualifiers to the token before the semicolon. */
export function parseVariables(cursor: Cursor): VariableDeclaration {
  const start = cursor.peek();
  const qualifiers = parseQualifiers(cursor);
  const type = parseType(cursor);
  return { kind: 'variables', start, qualifiers, type, declarators: parseDeclarators(cursor, type) };
}

/**
 * Parses the variables of a declaration, such as `a = 1.0, b[2]`. There are none in a declaration of a struct alone, and in `uniform
 * vec2;`, which declares nothing.
 */
export function parseDeclarators(cursor: Cursor, type: TypeSpecifier): Declarator[] {
  const declarators: Declarator[] = [];
  if (cursor.at(';')) return declarators;
  do {
    const name = cursor.name('the variable');
    const dimensions = parseDimensions(cursor);
    const equals = cursor.accept('=');
    const initializer = equals ? parseInitializer(cursor, type, dimensions) : null;
    declarators.push({ name, dimensions, equals, initializer, symbol: null });
  } while (cursor.accept(','));
  return declarators;
}

/** Parses an initializer. Desktop GLSL 4.20 also allows a list in braces (§4.1.11) instead of a constructor. */
function parseInitializer(cursor: Cursor, type: TypeSpecifier, dimensions: readonly Dimension[]): Expression {
  const open = cursor.accept('{');
  if (open === null) return parseAssignment(cursor);
  const whole = [...type.dimensions, ...dimensions];
  const args: Expression[] = [];
  while (!cursor.accept('}')) {
    if (args.length > 0) cursor.expect(',', `or "}" to go on with the list of line ${open.line}`);
    // A trailing comma is allowed.
    if (!cursor.at('}')) args.push(cursor.nested(() => parseInitializer(cursor, { ...type, dimensions: [] }, whole.slice(1))));
  }
  return constructorOf({ ...type, dimensions: whole, struct: null }, args);
}

/**
 * Whether a qualifier is at the cursor. Words such as `flat` and `smooth` are names in older GLSL, so they are qualifiers only before
 * another word.
 */
function atQualifier(cursor: Cursor): boolean {
  const token = cursor.peek();
  if (!QUALIFIERS.has(token.text)) return false;
  if (KEYWORDS.has(token.text)) return true;
  const after = cursor.peek(1);
  return token.text === 'layout' ? after.text === '(' : after.kind === 'word';
}

/** Whether the tokens at the cursor are an array type before a name (`Type[…] name`) or before a bracket (`Type[…](`). */
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
