import { readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import type { Result } from '../../../nodes/kit/diagnostics.ts';
import type { IsfShader } from '../isf/isf-shader.ts';
import { readIsf } from '../isf/read-isf.ts';
import { lex } from '../syntax/lexer.ts';
import { linkIsfDepth } from './link-depth.ts';
import { linkIsf } from './link-isf.ts';
import type { LinkedPass, LinkOptions } from './linked-pass.ts';
import { authorsNames } from './names.ts';

const IMAGE = { NAME: 'inputImage', TYPE: 'image' };

function made<T>({ output, diagnostics }: Result<T>): T {
  if (output === null) throw new Error(JSON.stringify(diagnostics));
  return output;
}

function read(body: string, header: Readonly<Record<string, unknown>> = {}): IsfShader {
  return made(readIsf(`/*${JSON.stringify({ ISFVSN: '2', ...header })}*/\n${body}`, 'test.fs'));
}

function link(body: string, header: Readonly<Record<string, unknown>> = {}, options: Partial<LinkOptions> = {}): readonly LinkedPass[] {
  return made(linkIsf(read(body, header), { node: 'n', ...options }));
}

/** The lines that are the author's. */
function printed(body: string, header: Readonly<Record<string, unknown>> = {}): string {
  const [pass] = link(body, header);
  const lines = pass?.shader.fragment.split('\n') ?? [];
  const map = pass?.shader.sourceMap?.lines ?? [];
  const mine = lines.filter((_, i) => map[i] !== undefined && map[i] !== null);
  return mine.join('\n');
}

describe('renaming', () => {
  test('globals get a prefix, locals keep their names, and what hides goes on hiding', () => {
    expect(
      printed(`
float tint = 0.5;
float shade(float tint, vec2 p) {
  float shade = tint;
  { vec2 tint = p; shade += tint.x; }
  return shade;
}
void main() {
  float x = shade(tint, vec2(1.0));
  gl_FragColor = vec4(x);
}`),
    ).toBe(`float a_tint = 0.5;
float a_shade(float tint, vec2 p) {
  float shade = tint;
  {
    vec2 tint = p;
    shade += tint.x;
  }
  return shade;
}
void a_main() {
  float x = a_shade(a_tint, vec2(1.0));
  scrim_fragColor = vec4(x);
}`);
  });

  test('struct names and members are no variables', () => {
    expect(printed('struct p { float p; };\nvoid main() { p p = p(1.0); gl_FragColor = vec4(p.p); }')).toContain('a_p p = a_p(1.0);');
  });

  test('an input may be called as a function of GLSL', () => {
    const text = printed('void main() { gl_FragColor = vec4(mix(0.0, 1.0, mix)); }', { INPUTS: [{ NAME: 'mix', TYPE: 'float' }] });
    expect(text).toContain('vec4(mix(0.0, 1.0, a_mix))');
  });

  test('an input may be called as what belongs to an image', () => {
    const [pass] = link('void main() { gl_FragColor = IMG_PIXEL(inputImage, vec2(inputImage_size)); }', {
      INPUTS: [IMAGE, { NAME: 'inputImage_size', TYPE: 'float' }],
    });
    const names = [...(pass?.samplers ?? []), ...(pass?.uniforms ?? [])].map((item) => item.name);
    expect(names).toEqual(['a1_inputImage', 'a_inputImage_size']);
  });

  test('printed names lead back to the author’s', () => {
    expect(authorsNames('a_tint')[0]).toBe('tint');
    expect(authorsNames('a12_tint')[0]).toBe('tint');
    expect(authorsNames('a_my_u_x')).toContain('my__x');
  });
});

describe('loops, for a preview', () => {
  const linked = (body: string) => {
    const shader = made(readIsf(`/*{}*/ void main() { float s = 0.0; ${body} gl_FragColor = vec4(s); }`, 'test.fs'));
    const [pass] = made(linkIsf(shader, { node: 'n', loopBudget: true }));
    return { loops: pass?.shader.loops, text: pass?.shader.fragment ?? '', vertex: pass?.shader.vertex ?? '' };
  };

  test('that end soon are left alone, long ones are looked at, and those that may never end are stopped', () => {
    const soon = linked('for (int i = 0; i < 100; i++) s += 0.1;');
    expect([soon.loops, soon.text.includes('scrim_spend'), soon.vertex.includes('scrim_isShut')]).toEqual([undefined, false, false]);
    const long = linked('for (int i = 0; i < 20000; i++) s += 0.1;');
    expect([long.loops, long.text.includes('return false;'), long.vertex.includes('scrim_isShut')]).toEqual(['counted', false, false]);
    for (const body of ['for (int i = 0; i < 300000; i++) s += 0.1;', 'while (s < 1.0) s += 0.1;']) {
      const stopped = linked(body);
      expect([stopped.loops, stopped.text.includes('return false;'), stopped.vertex.includes('scrim_isShut')]).toEqual([
        undefined,
        true,
        true,
      ]);
    }
  });
});

describe('source maps', () => {
  const library = ['filters/gaussian-blur.fs', 'filters/sobel-edges.fs', 'filters/color-temperature.fs', 'operators/mask.fs'];

  /** Starts that stand for something else: a discard, and what ISF's own words become. */
  const REPLACED = /^(?:scrim_|\{ scrim_)/;

  test.each(library)('every printed line of %s begins with the token it is mapped to', (file) => {
    const source = readFileSync(new URL(`../../../shader-library/${file}`, import.meta.url), 'utf8');
    const tokens = new Map(lex(source).map((token) => [`${token.line}:${token.column}`, token.text]));
    let mapped = 0;
    for (const pass of made(linkIsf(made(readIsf(source, file)), { node: 'n', loopBudget: true }))) {
      const { fragment, sourceMap } = pass.shader;
      expect(sourceMap).toMatchObject({ sources: [file], nodes: ['n'] });
      const lines = fragment.split('\n');
      expect(sourceMap?.lines).toHaveLength(lines.length - 1);
      sourceMap?.lines.forEach((entry, i) => {
        const text = lines[i]?.trim() ?? '';
        if (entry === null || REPLACED.test(text)) return;
        mapped += 1;
        const start = /^(?:[A-Za-z_]\w*|[\d.]+|\S)/.exec(text)?.[0] ?? '';
        expect([start, ...authorsNames(start)]).toContain(tokens.get(`${entry[1]}:${entry[2]}`));
      });
    }
    expect(mapped).toBeGreaterThan(8);
  });

  test('no printed line holds statements or text of two of the author’s lines', () => {
    const [pass] = link('void main() { float a = 1.0; float b =\n  a +\n  2.0; gl_FragColor = vec4(a, b,\n 0.0, 1.0); }');
    const lines = pass?.shader.fragment.split('\n') ?? [];
    const own = (pass?.shader.sourceMap?.lines ?? []).flatMap((entry, i) =>
      entry === null ? [] : [[entry[1], entry[2], lines[i]?.trim()]],
    );
    expect(own).toEqual([
      [2, 1, 'void a_main() {'],
      [2, 15, 'float a = 1.0;'],
      [2, 30, 'float b ='],
      [3, 3, 'a +'],
      [4, 3, '2.0;'],
      [4, 8, 'scrim_fragColor = vec4(a, b,'],
      [5, 2, '0.0, 1.0);'],
      [5, 13, '}'],
    ]);
  });
});

describe('what a pass is given', () => {
  test('only what it uses, in the order of the header', () => {
    const [pass] = link('void main() { gl_FragColor = tint * b * TIME + IMG_PIXEL(second, vec2(1.0)) + IMG_THIS_PIXEL(inputImage); }', {
      INPUTS: [
        IMAGE,
        { NAME: 'second', TYPE: 'image' },
        { NAME: 'third', TYPE: 'image' },
        { NAME: 'a', TYPE: 'float' },
        { NAME: 'b', TYPE: 'float' },
        { NAME: 'tint', TYPE: 'color' },
      ],
    });
    expect(pass).toMatchObject({
      passIndex: 0,
      target: { kind: 'output', format: 'rgba8' },
      samplers: [
        { name: 'a_inputImage', source: { kind: 'input', input: 'inputImage' } },
        { name: 'a_second', source: { kind: 'input', input: 'second' } },
      ],
      uniforms: [
        { name: 'TIME', type: 'float', source: { builtin: 'TIME' } },
        { name: 'a_b', type: 'float', source: { param: 'b' } },
        { name: 'a_tint', type: 'vec4', source: { param: 'tint' } },
      ],
    });
    expect(pass?.shader.fragment).toContain('uniform vec2 a_second_size;');
    expect(pass?.shader.fragment).not.toMatch(/third|a_a\b|a_inputImage_size/);
  });

  test('the size of its image, or the size of the texture that holds it', () => {
    const [pass] = link('void main() { gl_FragColor = vec4(IMG_SIZE(inputImage), IMG_SAMPLES(inputImage)); }', { INPUTS: [IMAGE] });
    expect(pass?.shader.fragment).toContain('vec4(a_inputImage_size, vec2(textureSize(a_inputImage, 0)))');
    expect(pass?.samplers).toMatchObject([{ name: 'a_inputImage' }]);
  });

  test('nothing for functions that nobody calls, though they are printed', () => {
    const [pass] = link('vec4 f() { return IMG_THIS_PIXEL(inputImage) * TIME; }\nvoid main() { gl_FragColor = vec4(1.0); }', {
      INPUTS: [IMAGE],
    });
    expect(pass).toMatchObject({ samplers: [], uniforms: [] });
    expect(pass?.shader.fragment).toContain('a_f()');
  });

  test('equal texts are equal shaders, whichever node they are linked for', () => {
    const shader = read('void main() { gl_FragColor = vec4(1.0); }');
    const [a] = made(linkIsf(shader, { node: 'one' }));
    const [b] = made(linkIsf(shader, { node: 'two' }));
    expect(a?.shader.id).toBe(b?.shader.id);
    expect(b?.shader.sourceMap?.nodes).toEqual(['two']);
    const [c] = link('void main() { gl_FragColor = vec4(0.9); }');
    expect(c?.shader.id).not.toBe(a?.shader.id);
  });

  test('passes that PASSINDEX does not tell apart share their text', () => {
    const passes = link('void main() { gl_FragColor = vec4(float(PASSINDEX)); }', { PASSES: [{ TARGET: 'a' }, { TARGET: 'b' }, {}] });
    expect(passes[0]?.shader.id).toBe(passes[1]?.shader.id);
    expect(passes.map((pass) => pass.passIndex)).toEqual([0, 1, 2]);
  });

  test('passes that nobody sees are left out', () => {
    expect(link('void main() { gl_FragColor = vec4(1.0); }', { PASSES: [{}, {}, {}] }).map((pass) => pass.passIndex)).toEqual([2]);
  });

  test('a last pass with a buffer, or a size, of its own is shown by a copy', () => {
    const kinds = (pass: object) =>
      link('void main() { gl_FragColor = vec4(1.0); }', { PASSES: [pass] }).map(({ target }) =>
        target.kind === 'buffer' ? target.name : 'output',
      );
    expect(kinds({ TARGET: 'a' })).toEqual(['output']);
    expect(kinds({ TARGET: 'a', PERSISTENT: true })).toEqual(['a', 'output']);
    expect(kinds({ WIDTH: 16 })).toEqual(['result', 'output']);
  });
});

describe('what is refused', () => {
  test('a uniform that nothing sets is a warning and stays 0', () => {
    const { output, diagnostics } = linkIsf(read('uniform float speed;\nvoid main() { gl_FragColor = vec4(speed); }'), { node: 'n' });
    expect(output).not.toBeNull();
    expect(diagnostics).toMatchObject([{ code: 'SCR043', severity: 'warning', line: 2, column: 15 }]);
  });

  test('an input declared once more is none', () => {
    const { diagnostics } = linkIsf(
      read(
        'uniform float speed;\nuniform sampler2D inputImage;\nvarying vec2 isf_FragNormCoord;\nvoid main() { gl_FragColor = vec4(speed) * IMG_THIS_PIXEL(inputImage); }',
        { INPUTS: [IMAGE, { NAME: 'speed', TYPE: 'float' }] },
      ),
      {
        node: 'n',
      },
    );
    expect(diagnostics).toEqual([]);
  });

  test('room depth is not read as an image, nor an image as room depth', () => {
    const header = { INPUTS: [IMAGE, { NAME: 'room', TYPE: 'depth' }] };
    for (const expression of [
      'IMG_THIS_PIXEL(room)',
      'ROOM_DEPTH(inputImage, vec2(0.5)) * vec4(1.0)',
      'LAYER_DEPTH(room, vec2(0.5)) * vec4(1.0)',
    ]) {
      expect(linkIsf(read(`void main() { gl_FragColor = ${expression}; }`, header), { node: 'n' }).diagnostics).toMatchObject([
        { code: 'SCR041', line: 2, column: 30 },
      ]);
    }
  });

  test('a curve is read at a place across, of the table of its param', () => {
    const header = { INPUTS: [IMAGE, { NAME: 'tone', TYPE: 'curve' }] };
    const { output } = linkIsf(read('void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) * CURVE(tone, 1); }', header), { node: 'n' });
    expect(output?.[0]?.samplers.map(({ source }) => source)).toEqual([
      { kind: 'input', input: 'inputImage' },
      { kind: 'table', of: 'curve', param: 'tone' },
    ]);
    expect(output?.[0]?.shader.fragment).toContain('tone_valueAt(1.0)');
    expect(output?.[0]?.uniforms).toEqual([]);
  });

  test('a gradient is read as a color with straight alpha', () => {
    const header = { INPUTS: [IMAGE, { NAME: 'tint', TYPE: 'gradient' }] };
    const { output } = linkIsf(read('void main() { gl_FragColor = GRADIENT(tint, IMG_THIS_PIXEL(inputImage).r); }', header), { node: 'n' });
    expect(output?.[0]?.samplers.map(({ source }) => source)).toContainEqual({ kind: 'table', of: 'gradient', param: 'tint' });
    expect(output?.[0]?.shader.fragment).toContain('vec4 a_tint_valueAt(float x) {\n  return scrim_straight(');
  });

  test('a curve is not read as an image or a gradient, nor an image as a curve', () => {
    const header = { INPUTS: [IMAGE, { NAME: 'tone', TYPE: 'curve' }] };
    for (const expression of [
      'IMG_THIS_PIXEL(tone)',
      'GRADIENT(tone, 0.5)',
      'texture2D(tone, vec2(0.5))',
      'vec4(CURVE(inputImage, 0.5))',
    ]) {
      expect(linkIsf(read(`void main() { gl_FragColor = ${expression}; }`, header), { node: 'n' }).diagnostics).toMatchObject([
        { code: 'SCR043', line: 2 },
      ]);
    }
  });

  test('depth is computed only by files that say so', () => {
    expect(() => linkIsfDepth(read('void main() {}', { INPUTS: [IMAGE] }), { node: 'n' })).toThrow('computes no depth');
  });
});
