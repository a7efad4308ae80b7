import type { FunctionDeclaration, Parameter, ParsedShader, VariableDeclaration } from './ast.ts';
import { type Cursor, createCursor } from './cursor.ts';
import { freeNames } from './free-names.ts';
import { parseDeclarators, parseQualifiers } from './parse-declaration.ts';
import { parseDimensions } from './parse-expression.ts';
import { parseBlock, skipPrecision } from './parse-statement.ts';
import { parseType } from './parse-type.ts';
import { preprocess } from './preprocess.ts';
import { GlslError, type Token } from './token.ts';

/**
 * Parses a fragment shader: GLSL ES 1.00 and 3.00, and features of desktop GLSL that authors of ISF files use.
 *
 * It is a recursive-descent parser: `@shaderfrog/glsl-parser` 7 (a PEG) took 300 ms for 105 lines and 1.0–1.8 s for 505 on two busy cores
 * where this one takes 2 and 6 ms, and an editor parses at every pause in typing. It also loses the positions of text from macros.
 *
 * @param macros Predefined macros beside those of `preprocess`.
 * @throws GlslError at the first mistake.
 */
export function parseShader(source: string, macros: Readonly<Record<string, number>> = {}): ParsedShader {
  const tokens = freeNames(preprocess(source, macros));
  refuseLength(tokens);
  const cursor = createCursor(tokens);
  const declarations: (FunctionDeclaration | VariableDeclaration)[] = [];
  while (cursor.peek().kind !== 'end') {
    if (cursor.accept(';')) continue;
    if (cursor.at('precision')) skipPrecision(cursor);
    else if (cursor.at('invariant') && cursor.peek(2).text === ';') cursor.next();
    else declarations.push(parseDeclaration(cursor));
  }
  return { declarations };
}

/** Maximum length of a shader, in characters of its tokens, because drivers take minutes for longer texts. */
export const MAX_TEXT = 1024 * 1024;

export const TOO_LONG = 'The shader is too long: it would become more than 1 MiB of GLSL.';

/** Throws if a shader is longer than `MAX_TEXT`. Called before parsing. */
function refuseLength(tokens: readonly Token[]): void {
  let length = 0;
  for (const token of tokens) {
    length += token.text.length;
    if (length > MAX_TEXT) throw new GlslError(token, TOO_LONG, 'SCR043');
  }
}

function parseDeclaration(cursor: Cursor): FunctionDeclaration | VariableDeclaration {
  const start = cursor.peek();
  const qualifiers = parseQualifiers(cursor);
  if (qualifiers.length > 0 && cursor.peek().kind === 'word' && cursor.peek(1).text === '{' && !cursor.at('struct')) {
    throw new GlslError(cursor.peek(), 'Blocks of uniforms cannot be used: declare values as INPUTS in the header.', 'SCR043');
  }
  if (start.kind !== 'word') throw cursor.unexpected('A function or a variable should begin here');
  const type = parseType(cursor);
  if (type.struct === null && cursor.peek(1).text === '(') {
    const name = cursor.name('the function');
    const parameters = parseParameters(cursor);
    const body = cursor.at('{') ? parseBlock(cursor) : null;
    if (body === null) cursor.expect(';', 'or a body in braces after the head of the function');
    return { kind: 'function', returnType: type, name, parameters, body, symbol: null };
  }
  const declarators = parseDeclarators(cursor, type);
  cursor.expect(';', 'after the declaration');
  return { kind: 'variables', start, qualifiers, type, declarators };
}

function parseParameters(cursor: Cursor): Parameter[] {
  cursor.expect('(', 'after the name of the function');
  const parameters: Parameter[] = [];
  if (cursor.at('void') && cursor.peek(1).text === ')') cursor.next();
  while (!cursor.accept(')')) {
    if (parameters.length > 0) cursor.expect(',', 'or ")" after the parameter');
    const qualifiers = parseQualifiers(cursor);
    const type = parseType(cursor);
    const name = cursor.at(',') || cursor.at(')') || cursor.at('[') ? null : cursor.name('the parameter');
    parameters.push({ qualifiers, type, name, dimensions: parseDimensions(cursor), symbol: null });
  }
  return parameters;
}
