import { existsSync } from 'node:fs';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { projectText, writeProject } from '../support/project-kit.ts';
import { scrim } from '../support/scrim.ts';

const FILTER = '/*{ "ISFVSN": "2", "INPUTS": [ { "NAME": "inputImage", "TYPE": "image" } ] }*/';

/** Each wrong in its own way, with the place that its author has to look at. */
const BROKEN = {
  'a-header.fs': ['/*{ "INPUTS": [ { "NAME": "a", "TYPE": "image" } }*/\nvoid main() {}', 'SCR040', 1, 50, 'comma'],
  'b-no-header.fs': ['void main() { gl_FragColor = vec4(1.0); }', 'SCR040', 1, 1, 'no header'],
  'c-syntax.fs': [`${FILTER}\nvoid main() {\n  gl_FragColor = vec4(1.0)\n}`, 'SCR041', 3, 27, '";" is missing'],
  'd-cube.fs': [
    '/*{ "ISFVSN": "2", "IMPORTED": { "sky": { "TYPE": "cube", "PATH": [ "a.png" ] } } }*/\nvoid main() { gl_FragColor = vec4(1.0); }',
    'SCR040',
    1,
    34,
    'six',
  ],
  'e-name.fs': [
    `${FILTER}\nvoid main() {\n  vec4 c = IMG_THIS_PIXEL(inputImage);\n  gl_FragColor = c * strength;\n}`,
    'SCR042',
    4,
    22,
    '"strength": undeclared',
  ],
  'f-second-pass.fs': [
    `/*{ "ISFVSN": "2", "INPUTS": [ { "NAME": "inputImage", "TYPE": "image" } ],
  "PASSES": [ { "TARGET": "kept", "PERSISTENT": true, "FLOAT": true }, {} ] }*/
void main() {
  if (PASSINDEX == 0) gl_FragColor = IMG_THIS_PIXEL(inputImage);
  else {
    vec3 color = IMG_THIS_PIXEL(kept);
    gl_FragColor = vec4(color, 1.0);
  }
}`,
    'SCR042',
    6,
    16,
    'convert',
  ],
  'g-endless.fs': [
    `${FILTER}
int turn(int i) {
  while (i >= 0) { i = (i + 1) % 100; }
  return i;
}
void main() {
  gl_FragColor = IMG_THIS_PIXEL(inputImage) * float(turn(1));
}`,
    'SCR044',
    3,
    3,
    'do not end',
  ],
  'h-technique.glsl': [
    '/*{ "INPUTS": [] }*/\n#include <light/strength>\nvec4 surface(const in Surface s) {\n  return vec4(s.color.rgb * strength, 1.0);\n}',
    'SCR042',
    4,
    29,
    '"strength": undeclared',
  ],
} as const;

/** What other hosts accept and many public files contain. */
const FINE = {
  // Version 1, with stray commas, an initializer that is not constant, a name of GLSL's own taken again, and whole numbers for fractions.
  'old.fs': `/*{ "INPUTS": [ { "NAME": "inputImage", "TYPE": "image", }, ,
 ] }*/
float start = TIME * 2.0;
float mix(float a) { return a; }
void main() { float x = 1; gl_FragColor = texture2D(inputImage, vv_FragNormCoord) * x * start * mix(1.0); }`,
  // As heavy as raymarchers are: 400 steps of a scene of eight octaves.
  'march.isf': `/*{ "ISFVSN": "2", "INPUTS": [ { "NAME": "steps", "TYPE": "long", "DEFAULT": 400, "MIN": 1, "MAX": 400 } ] }*/
float map(vec3 p) {
  float d = 0.0;
  for (int i = 0; i < 8; i++) d += sin(p.x * float(i)) * cos(p.y) / exp2(float(i));
  return length(p) - 1.0 + d * 0.1;
}
void main() {
  vec3 direction = normalize(vec3(isf_FragNormCoord - 0.5, 1.0));
  float t = 0.0;
  for (int i = 0; i < steps; i++) t += max(map(vec3(0.0, 0.0, -3.0) + direction * t) * 0.05, 0.001);
  gl_FragColor = vec4(vec3(t / 5.0), 1.0);
}`,
};

let folder = '';
beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'scrim-shaders-'));
  await writeProject(join(folder, 'broken'), Object.fromEntries(Object.entries(BROKEN).map(([name, [text]]) => [name, text])));
  await writeProject(join(folder, 'fine'), {
    ...FINE,
    'deep/er/plain.fs': `${FILTER}\nvoid main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }`,
  });
  await writeProject(join(folder, 'empty'), { 'read.me': '' });
  await writeProject(join(folder, 'alone'), { 'x.vs': 'void main() { isf_vertShaderInit(); }' });
  await writeProject(join(folder, 'beside'), {
    'a.fs': `${FILTER}\nvarying vec2 left;\nvoid main() { gl_FragColor = IMG_NORM_PIXEL(inputImage, left); }`,
    'a.vs': 'varying vec2 left;\nvoid main() {\n  isf_vertShaderInit();\n  left = isf_FragNormCoord - nowhere;\n}',
    'b.glsl':
      'uniform ivec2 size; // = ivec2(4)\nvec4 transition(vec2 p) { return mix(getFromColor(p), getToColor(p), progress * size.x); }',
  });
  const including = (chunk: string, call: string) =>
    `/*{ "DESCRIPTION": "One color." }*/\n#include <${chunk}>\nvec4 surface(const in Surface s) { return vec4(vec3(${call}), 1.0); }`;
  await writeProject(join(folder, 'chunked'), {
    'fine.glsl': including('light/strength', 'lightStrength(0.5)'),
    'wrong.glsl': including('own/wrong', 'wrong()'),
    'chunks/light/strength.glsl': 'float lightStrength(float x) { return x; }',
    'chunks/own/wrong.glsl': 'float wrong() {\n  return nowhere;\n}',
  });
});
afterAll(() => rm(folder, { recursive: true, force: true }));

const check = (...args: string[]) => scrim('shader', 'check', ...args);

interface Report {
  readonly files: readonly { readonly path: string; readonly ok: boolean; readonly diagnostics: readonly Record<string, unknown>[] }[];
}

describe('scrim shader check', () => {
  test('reads the vertex shader beside a file, and transitions', async () => {
    const { status, out } = await check(join(folder, 'beside'), '--json');
    const { files } = JSON.parse(out) as Report;
    expect([status, files.map(({ path, ok }) => [path, ok])]).toEqual([
      1,
      [
        [join(folder, 'beside', 'a.fs'), false],
        [join(folder, 'beside', 'b.glsl'), true],
      ],
    ]);
    const place = { file: join(folder, 'beside', 'a.vs'), line: 4, column: 30 };
    expect(files[0]?.diagnostics).toMatchObject([{ code: 'SCR042', severity: 'error', ...place }]);
  });

  test('checks a vertex shader with the file that it belongs to, once, and says which file is missing', async () => {
    const vertex = join(folder, 'beside', 'a.vs');
    const { status, out } = await check(vertex, join(folder, 'beside', 'a.fs'), '--json');
    const { files } = JSON.parse(out) as Report;
    expect([status, files.map(({ path }) => path)]).toEqual([1, [join(folder, 'beside', 'a.fs')]]);
    expect(files[0]?.diagnostics).toMatchObject([{ file: vertex, line: 4, column: 30 }]);

    const alone = await check(join(folder, 'alone', 'x.vs'));
    expect([alone.status, alone.err]).toEqual([
      2,
      expect.stringContaining('x.vs is the vertex shader of an ISF file x.fs, which is missing'),
    ]);
  });

  test('takes the chunks beside a technique before the library’s, and tells of mistakes in them', async () => {
    const { status, out } = await check(join(folder, 'chunked'), '--json');
    const { files } = JSON.parse(out) as Report;
    expect([status, files.map(({ path, ok }) => [path, ok])]).toEqual([
      1,
      [
        [join(folder, 'chunked', 'fine.glsl'), true],
        [join(folder, 'chunked', 'wrong.glsl'), false],
      ],
    ]);
    const place = { file: join(folder, 'chunked', 'chunks', 'own', 'wrong.glsl'), line: 2, column: 10 };
    expect(files[1]?.diagnostics).toMatchObject([{ code: 'SCR042', severity: 'error', ...place }]);
  });

  test('tells header, syntax, input, driver and loop errors at the author’s word', async () => {
    const { status, out, err } = await check(join(folder, 'broken'), '--json');
    expect([status, err]).toEqual([1, '']);
    const { files } = JSON.parse(out) as Report;
    expect(files.map(({ path, ok }) => [path, ok])).toEqual(Object.keys(BROKEN).map((name) => [join(folder, 'broken', name), false]));
    const first = files.map(({ diagnostics }) => diagnostics.at(-1));
    expect(first).toEqual(
      Object.entries(BROKEN).map(([name, [, code, line, column, words]]) =>
        expect.objectContaining({
          code,
          severity: 'error',
          file: join(folder, 'broken', name),
          line,
          column,
          message: expect.stringContaining(words),
        }),
      ),
    );
  });

  test('tells what is wrong above a syntax error first, and nothing that only follows from it', async () => {
    const above = {
      'syntax.fs': `${FILTER}
float later(float x);
vec3 tint() {
  vec3 c = vec2(1.0);
  float d = later(1.0);
  while (true) {
    d += nothing;
    d = = 2.0;
    if (d > 9.0) break;
  }
  return c * below;
}
float later(float x) { return x; }
void main() { gl_FragColor = vec4(tint(), 1.0); }`,
      'input.fs': `${FILTER}\nfloat a = nowhere;\nattribute vec2 left;\nvoid main() { gl_FragColor = vec4(a) + other; }`,
      'technique.glsl': `/*{ "DESCRIPTION": "A technique." }*/
float far(float x) { return x * nothing; }
vec4 surface(const in Surface s) {
  float d = s.uv;
  return vec4(d }`,
      'two.fs': `${FILTER}\nfloat a = nowhere;\nattribute vec2 left;\nvoid main() { gl_FragColor = vec4(a) }`,
    };
    await writeProject(join(folder, 'above'), above);
    const { status, out } = await check(join(folder, 'above'), '--json');
    const { files } = JSON.parse(out) as Report;
    expect([status, files.map(({ diagnostics }) => diagnostics.map(({ code, line, column }) => [code, line, column]))]).toEqual([
      1,
      [
        [
          ['SCR042', 2, 11],
          ['SCR043', 3, 16],
        ],
        [
          ['SCR042', 4, 10],
          ['SCR042', 7, 10],
          ['SCR041', 8, 9],
        ],
        [
          ['SCR042', 2, 33],
          ['SCR042', 4, 11],
          ['SCR041', 5, 17],
        ],
        [
          ['SCR042', 2, 11],
          ['SCR043', 3, 16],
          ['SCR041', 4, 38],
        ],
      ],
    ]);
  });

  test('accepts the library, what other hosts accept, and heavy loops that end', async () => {
    const library = resolve(import.meta.dirname, '../../shader-library');
    const { status, out } = await check(join(folder, 'fine'), library, '--json');
    const { files } = JSON.parse(out) as Report;
    const errors = files.flatMap(({ diagnostics }) => diagnostics.filter(({ severity }) => severity === 'error'));
    expect([status, errors]).toEqual([0, []]);
    expect(files.map(({ path }) => path)).toEqual(
      expect.arrayContaining([
        ...['old.fs', 'march.isf', 'deep/er/plain.fs'].map((name) => join(folder, 'fine', name)),
        join(library, 'filters', 'sepia.fs'),
        join(library, 'operators', 'over.fs'),
        join(library, 'techniques', 'toon.glsl'),
      ]),
    );
  });

  test('prints one line per problem, file first, and no progress without a terminal', async () => {
    const [path] = [join(folder, 'broken', 'e-name.fs')];
    const { status, out, err } = await check(path, join(folder, 'fine', 'march.isf'));
    expect([status, err]).toEqual([1, '']);
    expect(out.split('\n')).toEqual([
      `${path}:4:22: error SCR042: "strength": undeclared identifier. Check its spelling, capitals included, or declare it above.`,
      '2 shaders: 1 with errors.',
    ]);
  });

  test('refuses what is not there, and folders without shaders', async () => {
    for (const args of [[], [join(folder, 'nowhere')], [join(folder, 'empty')]]) {
      const { status, err } = await check(...args);
      expect([status, err]).toEqual([2, expect.stringContaining('Try: scrim shader check --help')]);
    }
  });
});

/** A project whose own filter stands between camera and screen. */
function projectWith(files: Readonly<Record<string, string>>, filter: string): Record<string, string> {
  const text = projectText({
    nodes: { 'video-a1b2': 'source/camera-video', 'own-a1b2': filter, 'screen-a1b2': 'output/screen' },
    wires: ['video-a1b2.layer -> own-a1b2.inputImage', 'own-a1b2.layer -> screen-a1b2.layer'],
  });
  return { 'project.scrim.json': text, ...files };
}

describe('a project with shaders of its own', () => {
  beforeAll(async () => {
    const [refused] = BROKEN['e-name.fs'];
    const [endless] = BROKEN['g-endless.fs'];
    const plain = `${FILTER}\nvoid main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }`;
    await writeProject(join(folder, 'refused'), projectWith({ 'shaders/glow.fs': refused }, 'filter/glow'));
    await writeProject(join(folder, 'endless'), projectWith({ 'shaders/round.fs': endless }, 'filter/round'));
    const counted = `${FILTER}\nvoid main() {\n  float s = 0.0;\n  for (int i = 0; i < 20000; i++) s += 1e-5;\n  gl_FragColor = IMG_THIS_PIXEL(inputImage) * s;\n}`;
    await writeProject(join(folder, 'counted'), projectWith({ 'shaders/long.fs': counted }, 'filter/long'));
    await writeProject(join(folder, 'taken'), projectWith({ 'shaders/plain.fs': plain }, 'filter/plain'));
  });

  test('is checked by a driver: what that refuses is told at its line, and what it takes is said to be taken', async () => {
    const { status, out } = await scrim('check', join(folder, 'refused'));
    expect(status).toBe(1);
    expect(out).toMatch(/^shaders\/glow\.fs:4:22 Glow \(own-a1b2\): error SCR042: "strength": undeclared/m);
    const endless = await scrim('check', join(folder, 'endless'));
    expect(endless.status).toBe(1);
    expect(endless.out).toMatch(/^shaders\/round\.fs:3:3: error SCR044: /m);
    const counted = await scrim('check', join(folder, 'counted'));
    expect([counted.status, counted.out]).toEqual([
      0,
      expect.stringMatching(/^shaders\/long\.fs:4:3: warning SCR044: The loops take long/m),
    ]);
    const taken = await scrim('check', join(folder, 'taken'), '--json');
    expect([taken.status, JSON.parse(taken.out)]).toEqual([0, { ok: true, driver: 'yes', diagnostics: [] }]);
  });

  test('is not exported with a shader that a driver rejects, with or without a poster, unless the check is off', async () => {
    const out = join(folder, 'page');
    const refused = await scrim('export', join(folder, 'refused'), '--out', out, '--no-poster');
    expect(refused.status).toBe(1);
    expect(refused.err).toMatch(/^shaders\/glow\.fs:4:22 Glow \(own-a1b2\): error SCR042: /m);
    expect(existsSync(out)).toBe(false);
    const unasked = await scrim('export', join(folder, 'refused'), '--out', out, '--no-poster', '--no-driver', '--json');
    expect([unasked.status, JSON.parse(unasked.out)]).toMatchObject([0, { ok: true, driver: 'not-wanted', diagnostics: [] }]);
  });
});
