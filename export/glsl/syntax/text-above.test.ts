import { describe, expect, test } from '@jest/globals';
import { parseShader } from './parse.ts';
import { textAbove } from './text-above.ts';

const MAIN = 'void main() {}';

/** The text above the `«` in a source. */
function above(marked: string): string | null {
  const before = marked.slice(0, marked.indexOf('«'));
  const place = { line: before.split('\n').length, column: before.length - before.lastIndexOf('\n') };
  return textAbove(marked.replace('«', ''), place, MAIN);
}

describe('the text above a place is a whole shader with the same lines', () => {
  test.each([
    ['inside of a statement', 'void main() {\n  float a = one;\n  float b = «;\n}', 'float a = one;', 'float b'],
    ['inside of nested blocks', 'void main() {\n  if (true) { for (;;) {\n  a();\n b( «', 'a();', 'b('],
    ['inside of a loop with its condition below', 'void main() {\n  do {\n  a();\n b( « } while (true); }', 'a();', 'b('],
    ['behind "do {}"', 'void main() {\n  a(); do { b(); } «; }', 'b();', 'do { b(); } ;'],
    ['inside of a head of "for"', 'void main() {\n  a();\n for (int i = 0; i < 3; «', 'a();', 'for'],
    ['inside of a struct', 'float a;\nstruct A { float b; «', 'float a;', 'struct'],
    ['inside of a list in braces', 'float a;\nfloat b[] = { 1.0, {«', 'float a;', 'float b'],
    ['inside of an #if', '#if 1\nfloat a;\n#ifdef B\n#else\nfloat c «', 'float a;', 'float c'],
    ['at a directive', '#if 1\nfloat a;\n#«wrong', 'float a;', 'wrong'],
    ['inside of the arguments of a macro', '#define F(x) x\nfloat a;\nfloat b = F(1.0 «;', 'float a;', 'float b'],
    ['inside of what one macro brings', '#define F(x) { x; }\nvoid main() {\na();\n«F(1.0)', 'a();', 'F(1.0)'],
    ['behind line ends of Windows', 'float a;\r\nfloat b = «;', 'float a;', 'float b'],
  ])('%s', (_, marked, kept, left) => {
    const text = above(marked) ?? '';
    expect(text).toContain(kept);
    expect(text).not.toContain(left);
    expect(marked.startsWith(text.slice(0, text.indexOf(kept)))).toBe(true);
    // `main` stands there once.
    expect(parseShader(text).declarations.filter((one) => one.kind === 'function' && one.name.text === 'main')).toHaveLength(1);
  });

  test('a function that was cut still gives a value', () => {
    expect(above('vec3 f(float x) {\n  a();\n  return «;\n}')).toMatch(/a\(\);\s*\{ vec3 above; return above; \} \}\s*void main/);
  });

  test('a loop that was cut still ends', () => {
    expect(above('void main() {\n  while (true) {\n  a();\n  do {\n  b();\n  c(«')).toMatch(
      /b\(\);\s*break; \} while \(true\); break; \} \}/,
    );
  });

  test('above the first statement there is nothing', () => {
    expect(above('/*{}*/\nfloat «;')).toBeNull();
  });
});
