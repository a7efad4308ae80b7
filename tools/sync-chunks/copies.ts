import { basename } from 'node:path';

/** Matches a function at the top level of a shader, with the comment lines directly above it. */
const FUNCTION = /^(?:\/\/[^\n]*\n)*\w+ (\w+)\([^)]*\) \{\n(?:[^}][^\n]*\n|\n)*\}\n/gm;

/**
 * The functions that several ISF files share: name → text with its comment. ISF has no includes, so each file contains copies.
 *
 * @param masters Path → text of the files in `shader-library/chunks/isf/`.
 * @throws Where a file does not hold exactly one function, named after the file in camel case.
 */
export function readMasters(masters: Readonly<Record<string, string>>): ReadonlyMap<string, string> {
  return new Map(
    Object.entries(masters).map(([path, text]) => {
      const found = [...text.matchAll(FUNCTION)];
      const expected = basename(path, '.glsl').replace(/-./g, ([, letter = '']) => letter.toUpperCase());
      if (found.length !== 1 || found[0]?.[0] !== text || found[0][1] !== expected) {
        throw new Error(`${path} does not hold exactly the function ${expected}.`);
      }
      return [expected, text];
    }),
  );
}

/**
 * Returns the shader with its copies of shared functions replaced by the text of the masters. A shader whose copies are current is returned
 * unchanged.
 */
export function syncCopies(shader: string, masters: ReadonlyMap<string, string>): string {
  return shader.replace(FUNCTION, (text, name: string) => masters.get(name) ?? text);
}
