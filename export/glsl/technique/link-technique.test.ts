import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import { linkTechnique, linkTechniqueAbove } from './link-technique.ts';
import { readTechnique } from './read-technique.ts';

const text = (name: string) => readFileSync(new URL(`../../../shader-library/${name}`, import.meta.url), 'utf8');
const chunkOf = (name: string) => (name.startsWith('no/') ? undefined : text(`chunks/${name}.glsl`));

function link(source: string, file = 'techniques/test.glsl') {
  const { output, diagnostics } = readTechnique(source, file);
  if (!output) throw new Error(JSON.stringify(diagnostics));
  return linkTechnique(output, { chunkOf, loopBudget: false });
}

function linked(source: string) {
  const { output, diagnostics } = link(source);
  if (!output) throw new Error(JSON.stringify(diagnostics));
  return output;
}

const HEADER = '/*{ "INPUTS": [{ "NAME": "tint", "TYPE": "color" }, { "NAME": "unused", "TYPE": "float" }] }*/';

describe('a technique is linked', () => {
  test('by symbols: nothing of the author’s can meet a name of the host, and inputs are those that are used', () => {
    const { vertex, fragment, uniforms } = linked(`${HEADER}
float cameraPosition(const in float x) { return x; }
void vertex(inout Vertex v) { v.position.y += cameraPosition(0.1); }
vec4 surface(const in Surface s) { return vec4(s.color.rgb * tint.rgb, 1.0); }`);
    expect(vertex).toContain('float a_cameraPosition(');
    expect(vertex).toContain('void a_vertex(inout a_Vertex v)');
    expect(vertex).not.toContain('a_tint');
    expect(fragment).not.toContain('a_cameraPosition');
    expect(fragment).toContain('uniform vec4 a_tint;');
    expect(uniforms).toEqual([{ name: 'a_tint', type: 'vec4', param: 'tint' }]);
  });

  test('by what is written, not by what comments say', () => {
    const { vertex } = linked(`${HEADER}\nvec4 surface(const in Surface s) { return s.color; } // no void vertex(inout Vertex v)`);
    expect(vertex).toContain('void a_vertex(inout a_Vertex v) {}');
  });

  test('with a vertex function of its own, or without', () => {
    expect(linked(`${HEADER}\nvec4 surface(const in Surface s) { return s.color; }`).vertex).toContain(
      'void a_vertex(inout a_Vertex v) {}',
    );
  });

  test('with chunks, each once, and every printed line knows its file and line', () => {
    const { trial } = linked(text('techniques/toon.glsl'));
    const map = trial.sourceMap;
    const chunks = ['received', 'diffuse', 'luminance', 'white', 'strength'].map((name) => `chunks/light/${name}.glsl`);
    expect(map?.sources).toEqual(['techniques/test.glsl', ...chunks]);
    const lines = trial.fragment.split('\n');
    expect(lines.filter((line) => line.includes('float a_lightStrength('))).toHaveLength(1);
    const at = (word: string) => map?.lines[lines.findIndex((line) => line.includes(word))];
    expect(at('luminance(light.radiance')).toEqual([5, 5, expect.any(Number)]);
    const author = text('techniques/toon.glsl').split('\n');
    const wanted = author.findIndex((line) => line.includes('if (outlinePx <= 0.0) discard;')) + 1;
    expect(at('scrim_discarded = true')?.slice(0, 2)).toEqual([0, wanted]);
  });

  test('with layers and pictures that it reads, linear, and without those that have no wire', () => {
    const header = `/*{ "INPUTS": [{ "NAME": "behind", "TYPE": "image" }, { "NAME": "other", "TYPE": "image", "OPTIONAL": true }],
"IMPORTED": { "strokes": { "PATH": "pictures/hatching-light.png" } } }*/`;
    const body = `${header}
vec4 surface(const in Surface s) { return IMG_THIS_PIXEL(behind) + IMG_NORM_PIXEL(other, VIEW_UV(s.position)) + texture(strokes, s.uv); }`;
    const { output: read } = readTechnique(body, 'techniques/test.glsl');
    const { output } = read ? linkTechnique(read, { chunkOf, loopBudget: false, absent: ['other'] }) : { output: null };
    expect(output?.samplers).toEqual([{ name: 'a_behind', input: 'behind' }]);
    expect(output?.pictures).toEqual([{ name: 'a_strokes', path: 'pictures/hatching-light.png' }]);
    expect(output?.fragment).toContain('scrim_linear(scrim_straight(textureLod(a_behind, at, 0.0)))');
    expect(output?.fragment).toContain('vec4 a_other_at(vec2 uv) { return vec4(0.0); }');
    expect(output?.vertex).not.toContain('sampler2D');
  });

  test('as the README teaches it', () => {
    const taught = [...text('README.md').matchAll(/```glsl\n([\s\S]*?)```/g)]
      .map(([, code = '']) => code)
      .find((code) => code.includes('Surface s'));
    expect(linked(taught ?? '').uniforms.map(({ param }) => param)).toEqual(['tint']);
  });

  test.each(readdirSync('shader-library/techniques'))('%s, as it ships', (name) => {
    const { diagnostics } = link(text(`techniques/${name}`), `techniques/${name}`);
    expect(diagnostics).toEqual([]);
  });
});

describe('what is wrong with a technique is said on its line', () => {
  test('where it asks a layer for its depth', () => {
    const { diagnostics } = link(
      '/*{ "INPUTS": [{ "NAME": "a", "TYPE": "image" }] }*/\nvec4 surface(const in Surface s) { return vec4(LAYER_DEPTH(a, s.uv)); }',
    );
    expect(diagnostics).toEqual([expect.objectContaining({ code: 'SCR043', message: expect.stringContaining('not its depth') })]);
  });

  test.each([
    ['vec4 other() { return vec4(1.0); }', 1, 'The technique has no "vec4 surface(const in Surface s) { … }".'],
    ['vec4 surface(vec3 s) { return vec4(1.0); }', 2, '"surface" must return vec4 and take one Surface.'],
    ['#include <no/such>\nvec4 surface(Surface s) { return s.color; }', 2, 'The chunk “no/such” does not exist.'],
    ['vec4 surface(Surface s) {\n  return s.color\n}', 3, expect.stringContaining(';')],
    [
      'void vertex(inout Vertex v) { v.position += LIGHT(0).towards; }\nvec4 surface(Surface s) { return s.color; }',
      2,
      'Lights and what is behind are available in "surface" only, not in "vertex".',
    ],
  ])('%s', (body, line, message) => {
    const { output, diagnostics } = link(`${HEADER}\n${body}`);
    expect(output).toBeNull();
    expect(diagnostics).toEqual([expect.objectContaining({ line, message, severity: 'error', file: 'techniques/test.glsl' })]);
  });

  describe('and what stands above it as well', () => {
    const above = (body: string) => {
      const { output } = readTechnique(`${HEADER}\n${body}`, 'techniques/test.glsl');
      if (!output) throw new Error('The header cannot be read.');
      const options = { chunkOf: (name: string) => (name === 'own' ? OWN : chunkOf(name)), loopBudget: true };
      const [refused] = linkTechnique(output, options).diagnostics;
      return refused ? linkTechniqueAbove(output, options, refused) : null;
    };
    const OWN = 'float wash(float x) {\n  return x * missing;\n}\nfloat ink( { }\nfloat last() { return 1.0; }';

    test('functions that nothing calls yet, with the function that is cut off, for the driver', () => {
      const found = above('float far() { return missing; }\nvec4 surface(const in Surface s) {\n  float a = s.uv.x;\n  float b = ;\n}');
      expect(found?.before).toEqual({ file: 'techniques/test.glsl', place: { line: 5, column: 13 } });
      const trial = found?.output?.trial;
      const lines = trial?.fragment.split('\n') ?? [];
      const at = (word: string) => trial?.sourceMap?.lines[lines.findIndex((line) => line.includes(word))];
      expect(at('missing')?.slice(0, 2)).toEqual([0, 2]);
      expect(at('s.uv.x')?.slice(0, 2)).toEqual([0, 4]);
    });

    test('in a chunk, and with chunks above one that does not exist', () => {
      const inChunk = above('#include <own>\nvec4 surface(const in Surface s) { return vec4(wash(1.0)); }');
      expect(inChunk?.before).toMatchObject({ file: 'chunks/own.glsl', place: { line: 4 } });
      const map = inChunk?.output?.trial.sourceMap;
      expect(map?.lines.map((entry) => entry?.slice(0, 2))).toContainEqual([1, 2]);
      const missing = above(
        'float far() { return missing; }\n#include <no/such>\nvec4 surface(const in Surface s) { return vec4(far()); }',
      );
      expect(missing?.output?.trial.fragment).toContain('return missing;');
    });

    test('what Scrim itself finds there, once for each place', () => {
      const found = above(
        'void vertex(inout Vertex v) { v.position += LIGHT(0).towards; }\nfloat deep() { return IMG_PIXEL(nowhere, vec2(0.0)).x; }\nvec4 surface(Surface s) { return s.color }',
      );
      expect(found?.diagnostics.map(({ line, code }) => [line, code])).toEqual([
        [2, 'SCR043'],
        [3, 'SCR041'],
      ]);
    });

    test('nothing, where there is nothing', () => {
      expect(above('vec4 ((;')).toBeNull();
    });
  });

  test('and of its header', () => {
    const { diagnostics } = readTechnique(
      '/*{ "INPUTS": [\n{ "NAME": "a", "TYPE": "audio" }],\n"PASSES": [{ "SIDE": "up" }] }*/',
      'x.glsl',
    );
    expect(diagnostics.map(({ code, line }) => [code, line])).toEqual([
      ['SCR040', 2],
      ['SCR040', 3],
    ]);
    const taken = readTechnique('/*{ "INPUTS": [{ "NAME": "EYE", "TYPE": "color" }] }*/', 'x.glsl');
    expect(taken.diagnostics).toEqual([expect.objectContaining({ code: 'SCR040', line: 1, message: expect.stringContaining('"EYE"') })]);
  });
});
