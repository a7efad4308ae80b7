import type { StructDeclaration, StructMember, TypeSpecifier } from './ast.ts';
import type { Cursor } from './cursor.ts';
import { parseDimensions, parseTypeName } from './parse-expression.ts';
import { DROPPED_QUALIFIERS, PRECISIONS } from './words.ts';

/** Parses `vec3`, `float[4]` or `struct Ray { … }`; a precision before it is dropped. */
export function parseType(cursor: Cursor): TypeSpecifier {
  while (PRECISIONS.has(cursor.peek().text)) cursor.next();
  if (cursor.at('struct')) {
    const struct = parseStruct(cursor);
    return { name: struct.name ?? struct.start, dimensions: parseDimensions(cursor), struct, type: '', symbol: null };
  }
  const name = parseTypeName(cursor);
  return { name, dimensions: parseDimensions(cursor), struct: null, type: '', symbol: null };
}

function parseStruct(cursor: Cursor): StructDeclaration {
  const start = cursor.next();
  const name = cursor.at('{') ? null : cursor.name('the struct');
  cursor.expect('{', 'after the name of the struct');
  const members: StructMember[] = [];
  while (!cursor.accept('}')) {
    while (DROPPED_QUALIFIERS.has(cursor.peek().text)) cursor.next();
    const type = cursor.nested(() => parseType(cursor));
    do {
      members.push({ type, name: cursor.name('a member of the struct'), dimensions: parseDimensions(cursor) });
    } while (cursor.accept(','));
    cursor.expect(';', 'after the member of the struct');
  }
  return { start, name, members, symbol: null };
}
