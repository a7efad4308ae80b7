import { expect, test } from '@jest/globals';
import { readIsf } from '../isf/read-isf.ts';
import { linkIsf } from './link-isf.ts';

function link(text: string) {
  const { output } = readIsf(`/*{}*/\n${text}`, 'test.fs');
  if (output === null) throw new Error('The header cannot be read.');
  const { output: passes, diagnostics } = linkIsf(output, { node: 'n' });
  return { text: passes?.[0]?.shader.fragment ?? '', samplers: passes?.[0]?.samplers, diagnostics };
}

test('declarations of nothing declare nothing', () => {
  const { text, diagnostics } = link('uniform vec2 ;\nfloat;\nvoid main() { float; gl_FragColor = vec4(1.0); }');
  expect(diagnostics).toEqual([]);
  expect(text).not.toContain('uniform vec2');
});

test('words that only newer GLSL has are names in files that declare them', () => {
  const { text, diagnostics } = link(
    'float f(float case) { return case * 2.0; }\nmat3 mat4x3(float uint) { return mat3(uint); }\nvoid main() { gl_FragColor = vec4(mat4x3(0.1)[0], f(0.25)); }',
  );
  expect(diagnostics).toEqual([]);
  expect(text).not.toMatch(/\b(?:case|uint|mat4x3)\b/);
});

test.each([
  ['second in a list', 'float a = max(1.0, 2.0), case;\nvoid main() { gl_FragColor = vec4(a + case); }'],
  ['third in a list of a block', 'void main() { const highp vec2 a, b[2], case = vec2(1.0); gl_FragColor = vec4(case, a); }'],
  ['second in the head of a loop', 'void main() { for (int i = 0, case = 3; i < case; i++) gl_FragColor = vec4(1.0); }'],
  ['a struct', 'struct uint { float a; };\nuint x;\nvoid main() { x = uint(1.0); gl_FragColor = vec4(x.a); }'],
  ['a member of a struct', 'struct A { float a, case; };\nvoid main() { A x; x.case = 1.0; gl_FragColor = vec4(x.case); }'],
])('such a word declared as %s', (_, text) => {
  const linked = link(text);
  expect(linked.diagnostics).toEqual([]);
  expect(linked.text).not.toMatch(/\b(?:case|uint)\b/);
});

test('and a message about one has it as it is written', () => {
  const { diagnostics } = link('uniform float case;\nvoid main() { gl_FragColor = vec4(case); }');
  expect(diagnostics).toMatchObject([{ line: 2, column: 15, message: expect.stringContaining('"case"') }]);
  const refused = link('float a, case;\nvoid main() { gl_FragColor = vec4(case) case; }').diagnostics;
  expect(refused).toMatchObject([{ line: 3, message: expect.stringContaining('"case" follows') }]);
});

test('and words of GLSL in files that do not', () => {
  const { text, diagnostics } = link(
    'float f(int n) { switch (n) { case 0: return 1.0; } mat4x3 m = mat4x3(1.0); return m[0].x; }\nvoid main() { gl_FragColor = vec4(f(1)); }',
  );
  expect(diagnostics).toEqual([]);
  expect(text).toMatch(/case 0:[\s\S]*mat4x3 m = mat4x3\(1\.0\)/);
});

test.each(['', 'out vec4 isf_FragColor;'])('isf_FragColor is gl_FragColor: "%s"', (declaration) => {
  const { text, diagnostics } = link(`${declaration}\nvoid main() { isf_FragColor = vec4(0.25); isf_FragColor.a = 1.0; }`);
  expect(diagnostics).toEqual([]);
  expect(text).toBe(link(`\nvoid main() { gl_FragColor = vec4(0.25); gl_FragColor.a = 1.0; }`).text);
});

test('an image that nobody brings is transparent, and told of', () => {
  const { text, samplers, diagnostics } = link(
    'uniform sampler2D other;\nuniform samplerCube sky;\nvoid main() { gl_FragColor = texture2D(other, vec2(0.5)) + textureCube(sky, vec3(1.0)); }',
  );
  expect(diagnostics).toMatchObject([
    { code: 'SCR043', severity: 'warning', line: 2, column: 19, message: expect.stringContaining('"other", so it stays transparent') },
    { code: 'SCR043', severity: 'warning', line: 3, column: 21, message: expect.stringContaining('"sky", so it stays transparent') },
  ]);
  expect(samplers).toEqual([]);
  expect(text).toMatch(/vec4 a_other_at\(vec2 uv\) { return vec4\(0\.0\); }[\s\S]*vec4 a_sky_at\(vec3 uv\) { return vec4\(0\.0\); }/);
});
