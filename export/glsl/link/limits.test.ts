import { describe, expect, test } from '@jest/globals';
import { readIsf } from '../isf/read-isf.ts';
import { linkIsf } from './link-isf.ts';

function link(source: string) {
  const read = readIsf(source, 'test.fs');
  if (read.output === null) return read;
  return linkIsf(read.output, { node: 'n', loopBudget: true });
}

function withImages(count: number): string {
  const names = Array.from({ length: count }, (_, i) => `image${i}`);
  const inputs = names.map((name) => `{ "NAME": "${name}", "TYPE": "image" }`).join(',\n');
  return `/*{ "INPUTS": [\n${inputs} ] }*/\nvoid main() { gl_FragColor = ${names.map((name) => `IMG_THIS_PIXEL(${name})`).join(' + ')}; }`;
}

describe('what runs on some devices only is refused', () => {
  test('more images than 16, at the line of the seventeenth', () => {
    expect(link(withImages(16))).toMatchObject({ diagnostics: [], output: [{ samplers: { length: 16 } }] });
    const { output, diagnostics } = link(withImages(20));
    expect(output).toBeNull();
    expect(diagnostics).toMatchObject([{ code: 'SCR043', severity: 'error', line: 18, column: 11 }]);
    expect(diagnostics[0]?.message).toMatch(/reads 20 images, .* guarantees only 16/);
  });

  test('a text that drivers take minutes for', () => {
    const { output, diagnostics } = link(`/*{}*/ void main() { float a = 0.0;\nfloat ${'a'.repeat(1024 * 1024)}; }`);
    expect([output, diagnostics.length]).toEqual([null, 1]);
    expect(diagnostics[0]?.message).toContain('too long');
  });

  test('calls that go deeper than WebGL does, at the function where they do', () => {
    const chain = Array.from({ length: 3000 }, (_, i) => `float f${i + 1}(float x) { return f${i}(x); }`).join('\n');
    const { diagnostics } = link(`/*{}*/\nfloat f0(float x) { return x; }\n${chain}\nvoid main() { gl_FragColor = vec4(f3000(1.0)); }`);
    expect(diagnostics).toMatchObject([{ code: 'SCR043', severity: 'error', line: 258, column: 7 }]);
    expect(diagnostics[0]?.message).toContain('"f256"');
  });

  test('noperspective, which WebGL 2 does not have', () => {
    const { diagnostics } = link('/*{}*/\nnoperspective in vec2 uv;\nvoid main() { gl_FragColor = uv.xyxy; }');
    expect(diagnostics).toMatchObject([{ code: 'SCR043', severity: 'error', line: 2, column: 1 }]);
  });
});

test.each(['LE', 'BE'])('a file in UTF-16 %s is told as what it is', (order) => {
  const bytes = Buffer.from(`\ufeff/*{ "INPUTS": [] }*/ void main() {}`, 'utf16le');
  const { output, diagnostics } = link((order === 'LE' ? bytes : bytes.swap16()).toString('utf8'));
  expect(output).toBeNull();
  expect(diagnostics).toMatchObject([{ code: 'SCR040', fix: 'Save it as UTF-8.' }]);
  expect(diagnostics[0]?.message).toContain('UTF-16');
});
