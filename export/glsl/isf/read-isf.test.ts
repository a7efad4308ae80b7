import { describe, expect, test } from '@jest/globals';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { IsfShader } from './isf-shader.ts';
import { readIsf } from './read-isf.ts';

function read(header: string): IsfShader {
  const { output, diagnostics } = readIsf(`/*${header}*/\nvoid main() {}`, 'filters/test.fs');
  if (output === null) throw new Error(JSON.stringify(diagnostics));
  return output;
}

function problems(header: string): readonly Diagnostic[] {
  return readIsf(`/*${header}*/\nvoid main() {}`, 'filters/test.fs').diagnostics;
}

describe('inputs', () => {
  test('every type, with what it may have', () => {
    const { inputs } = read(`{ "ISFVSN": "2", "INPUTS": [
      { "NAME": "flash", "TYPE": "event" },
      { "NAME": "on", "TYPE": "bool", "DEFAULT": true },
      { "NAME": "mode", "TYPE": "long", "VALUES": [3, 5], "LABELS": ["three", "five"], "DEFAULT": 5 },
      { "NAME": "step", "TYPE": "long", "MIN": 1, "MAX": 3, "DEFAULT": 2 },
      { "NAME": "size", "TYPE": "float", "MIN": 1.0, "MAX": 9.0, "DEFAULT": 2.5, "IDENTITY": 1.0, "LABEL": "Size", "DOC": "How large.", "UNIT": "px", "STEP": 0.5 },
      { "NAME": "center", "TYPE": "point2D", "DEFAULT": [0.25, 0.75], "MIN": [0, 0], "MAX": [1, 1] },
      { "NAME": "tint", "TYPE": "color", "DEFAULT": [1.0, 0.5, 0.0] },
      { "NAME": "picture", "TYPE": "image", "OPTIONAL": true },
      { "NAME": "sound", "TYPE": "audio", "MAX": 256 },
      { "NAME": "bars", "TYPE": "audioFFT" },
      { "NAME": "room", "TYPE": "depth" },
      { "NAME": "tone", "TYPE": "curve" },
      { "NAME": "bow", "TYPE": "curve", "DEFAULT": [[0, 0.2], [0.5, 0.75], [1, 1]] }
    ] }`);
    expect(inputs.map((input) => [input.name, input.type, input.default])).toEqual([
      ['flash', 'event', []],
      ['on', 'bool', [1]],
      ['mode', 'long', [5]],
      ['step', 'long', [2]],
      ['size', 'float', [2.5]],
      ['center', 'point2D', [0.25, 0.75]],
      ['tint', 'color', [1, 0.5, 0, 1]],
      ['picture', 'image', []],
      ['sound', 'audio', []],
      ['bars', 'audioFFT', []],
      ['room', 'depth', []],
      ['tone', 'curve', [0, 0, 1, 1]],
      ['bow', 'curve', [0, 0.2, 0.5, 0.75, 1, 1]],
    ]);
    expect(inputs[2]?.choices).toEqual([
      { value: 3, label: 'three' },
      { value: 5, label: 'five' },
    ]);
    expect(inputs[3]?.choices.map((choice) => choice.value)).toEqual([1, 2, 3]);
    expect(inputs[4]).toMatchObject({
      min: [1],
      max: [9],
      identity: [1],
      label: 'Size',
      doc: 'How large.',
      unit: 'px',
      step: 0.5,
      line: 6,
      column: 17,
    });
    expect(inputs[7]?.optional).toBe(true);
  });

  test('values in the forms that files in the wild have', () => {
    const { inputs } = read(`{ "INPUTS": [
      { "NAME": "a", "TYPE": "float", "DEFAULT": "0.5" },
      { "NAME": "b", "TYPE": "bool", "DEFAULT": 1.0 },
      { "NAME": "c", "TYPE": "long", "DEFAULT": 2.0, "VALUES": ["1", "2"] },
      { "NAME": "d", "TYPE": "point2D", "DEFAULT": 0.5 },
      { "NAME": "e", "TYPE": "float", "MIN": 2, "MAX": 4 }
    ] }`);
    expect(inputs.map((input) => input.default)).toEqual([[0.5], [1], [2], [0.5, 0.5], [2]]);
  });

  test('SCRIM_UNITS names units from outside of the inputs', () => {
    expect(read('{ "SCRIM_UNITS": { "r": "px" }, "INPUTS": [{ "NAME": "r", "TYPE": "float" }] }').inputs[0]?.unit).toBe('px');
  });

  test('HANDLE names the part of the gizmo, if the type can have it', () => {
    const inputs = '{ "NAME": "c", "TYPE": "point2D", "HANDLE": "center" }, { "NAME": "r", "TYPE": "float", "HANDLE": "extent" }';
    const shape = '{ "NAME": "s", "TYPE": "point2D", "HANDLE": "size" }, { "NAME": "f", "TYPE": "float", "HANDLE": "feather" }';
    const handles = ['center', 'extent', 'size', 'feather'];
    expect(read(`{ "INPUTS": [${inputs}, ${shape}] }`).inputs.map(({ handle }) => handle)).toEqual(handles);
    const wrong = '{ "INPUTS": [{ "NAME": "r", "TYPE": "float",\n "HANDLE": "center" }] }';
    expect(read(wrong).inputs[0]?.handle).toBeNull();
    expect(problems(wrong)).toMatchObject([{ code: 'SCR040', severity: 'warning', line: 2 }]);
  });

  test.each([
    ['a type that does not exist', '{ "INPUTS": [\n  { "NAME": "x", "TYPE": "flaot" } ] }', 2, 26],
    ['no type', '{ "INPUTS": [\n  { "NAME": "x" } ] }', 2, 3],
    ['no name', '{ "INPUTS": [\n  { "TYPE": "float" } ] }', 2, 3],
    ['a name with a space', '{ "INPUTS": [\n  { "NAME": "my x", "TYPE": "float" } ] }', 2, 13],
    ['a name twice', '{ "INPUTS": [ { "NAME": "x", "TYPE": "float" },\n  { "NAME": "x", "TYPE": "bool" } ] }', 2, 13],
    ['inputs that are no list', '{ "INPUTS":\n { } }', 2, 2],
    ['an input that is no object', '{ "INPUTS": [\n 4 ] }', 2, 2],
  ])('%s is an error at its place', (_, header, line, column) => {
    expect(problems(header)).toMatchObject([{ code: 'SCR040', severity: 'error', line, column, file: 'filters/test.fs' }]);
  });

  test.each([
    ['a default outside of its range', '{ "INPUTS": [ { "NAME": "x", "TYPE": "float", "MIN": 0, "MAX": 1,\n "DEFAULT": 7 } ] }', [1]],
    ['a range upside down', '{ "INPUTS": [ { "NAME": "x", "TYPE": "float",\n "MIN": 1, "MAX": 0, "DEFAULT": 7 } ] }', [7]],
    ['a default of another type', '{ "INPUTS": [ { "NAME": "x", "TYPE": "float",\n "DEFAULT": "much" } ] }', [0]],
    ['a default that is no choice', '{ "INPUTS": [ { "NAME": "x", "TYPE": "long", "VALUES": [4, 5],\n "DEFAULT": 9 } ] }', [4]],
    ['a curve of one point', '{ "INPUTS": [ { "NAME": "x", "TYPE": "curve",\n "DEFAULT": [[0, 0.5]] } ] }', [0, 0, 1, 1]],
    ['a curve that goes back', '{ "INPUTS": [ { "NAME": "x", "TYPE": "curve",\n "DEFAULT": [[1, 0], [0, 1]] } ] }', [0, 0, 1, 1]],
    ['a unit that nobody knows', '{ "INPUTS": [ { "NAME": "x", "TYPE": "float",\n "UNIT": "parsec" } ] }', [0]],
  ])('%s is a warning, and the input works', (_, header, value) => {
    expect(problems(header)).toMatchObject([{ code: 'SCR040', severity: 'warning', line: 2 }]);
    expect(read(header).inputs[0]?.default).toEqual(value);
  });
});

describe('passes', () => {
  test('targets, sizes and flags', () => {
    const { passes } = read(`{ "INPUTS": [{ "NAME": "part", "TYPE": "float" }], "PASSES": [
      { "TARGET": "small", "WIDTH": "$WIDTH / 2.0", "HEIGHT": 64, "FLOAT": true },
      { "TARGET": "memory", "PERSISTENT": "YES", "WIDTH": "floor($part * $HEIGHT)", "HEIGHT": "$HEIGHT" },
      { } ] }`);
    expect(passes).toEqual([
      { target: 'small', persistent: false, float: true, half: false, width: [{ op: 'width' }, 2, { op: '/' }], height: [64] },
      {
        target: 'memory',
        persistent: true,
        float: false,
        half: false,
        width: [{ param: 'part' }, { op: 'height' }, { op: '*' }, { op: 'floor' }],
        height: null,
      },
      { target: null, persistent: false, float: false, half: false, width: null, height: null },
    ]);
  });

  test('none is one that makes the output', () => {
    expect(read('{ }').passes).toHaveLength(1);
  });

  test('version 1 names its persistent buffers apart', () => {
    const list = read('{ "PERSISTENT_BUFFERS": ["a"], "PASSES": [{ "TARGET": "a" }, { "TARGET": "b" }] }');
    expect(list.version).toBe(1);
    expect(list.passes.map((pass) => pass.persistent)).toEqual([true, false]);
    const settings = read('{ "PERSISTENT_BUFFERS": { "a": { "WIDTH": 1, "FLOAT": true } }, "PASSES": [{ "TARGET": "a" }] }');
    expect(settings.passes[0]).toMatchObject({ persistent: true, float: true, width: [1] });
  });

  test('a mistake in a size is shown at its character', () => {
    expect(problems('{ "PASSES": [{ "TARGET": "a",\n "WIDTH": "$WIDTH * $half" }] }')).toMatchObject([
      { severity: 'error', line: 2, column: 21 },
    ]);
  });

  test('a target with the name of an input is refused', () => {
    expect(problems('{ "INPUTS": [{ "NAME": "x", "TYPE": "float" }], "PASSES": [{ "TARGET": "x" }] }')).toMatchObject([
      { severity: 'error' },
    ]);
  });
});

describe('the header as a whole', () => {
  test('kinds go by the images', () => {
    const image = (name: string) => `{ "NAME": "${name}", "TYPE": "image" }`;
    expect(read('{ }').kind).toBe('generator');
    expect(read(`{ "INPUTS": [${image('inputImage')}] }`).kind).toBe('filter');
    expect(read(`{ "INPUTS": [${image('startImage')}, ${image('endImage')}, { "NAME": "progress", "TYPE": "float" }] }`).kind).toBe(
      'operator',
    );
  });

  test('imports as an object, as a list and as a cube', () => {
    expect(read('{ "IMPORTED": { "a": { "PATH": "a.png" } } }').imported).toMatchObject([{ name: 'a', paths: ['a.png'], cube: false }]);
    expect(read('{ "IMPORTED": [{ "NAME": "b", "PATH": "b.png" }] }').imported).toMatchObject([{ name: 'b', paths: ['b.png'] }]);
    expect(read('{ "IMPORTED": { "c": { "TYPE": "cube", "PATH": ["1", "2", "3", "4", "5", "6"] } } }').imported).toMatchObject([
      { cube: true },
    ]);
  });

  test.each([
    ['trailing commas', '{ "INPUTS": [ { "NAME": "x", "TYPE": "float", }, ], }', 0],
    ['doubled commas', '{ "INPUTS": [ { "NAME": "x",, "TYPE": "float" },, ] }', 1],
    ['a missing comma', '{ "INPUTS": [ { "NAME": "x" "TYPE": "float" } ] }', 1],
    ['a tab in a text', '{ "DESCRIPTION": "a\tb", "INPUTS": [ { "NAME": "x", "TYPE": "float" } ] }', 1],
    ['a line break in a text', '{ "DESCRIPTION": "a\nb", "INPUTS": [ { "NAME": "x", "TYPE": "float" } ] }', 1],
    ['a comment', '{ // why\n "INPUTS": [ { "NAME": "x", "TYPE": "float" } ] }', 0],
    ['something behind it', '{ "INPUTS": [ { "NAME": "x", "TYPE": "float" } ] } by me', 1],
    ['numbers as GLSL writes them', '{ "INPUTS": [ { "NAME": "x", "TYPE": "float", "DEFAULT": .5, "MIN": -1., "MAX": +1.0f } ] }', 1],
    ['names without quotes, and a truth in capitals', '{ INPUTS: [ { NAME: "x", TYPE: "float", DEFAULT: TRUE } ] }', 1],
    ['other quotes', "{ 'INPUTS': [ { “NAME”: “x”, 'TYPE': 'float' } ] }", 1],
    ['a comment after #, and semicolons', '{ # why\n "INPUTS": [ { "NAME": "x"; "TYPE": "float" } ]; }', 1],
    ['a backslash that escapes nothing', '{ "DESCRIPTION": "C:\\user", "INPUTS": [ { "NAME": "x", "TYPE": "float" } ] }', 1],
    ['nothing where lists may be', '{ "INPUTS": [ { "NAME": "x", "TYPE": "float" } ], "PASSES": null, "IMPORTED": {}, "VSN": null }', 0],
    ['blank lines', '\n\n{ "INPUTS": [ { "NAME": "x", "TYPE": "float" } ] }', 0],
  ])('%s is read', (_, header, warnings) => {
    expect(read(header).inputs).toHaveLength(1);
    const found = problems(header);
    expect(found.every((problem) => problem.severity === 'warning')).toBe(true);
    expect(found.length > 0).toBe(warnings > 0);
  });

  test.each([
    ['no comment', 'void main() {}', 1, 1],
    ['no end of the comment', '\n/* { "INPUTS": [] }', 2, 1],
    ['no JSON', '/* hello */ void main() {}', 1, 4],
    ['a list', '/* [1] */ void main() {}', 1, 4],
    ['a missing brace', '/*{ "INPUTS": [\n  { "NAME": "x", "TYPE": "float" ] }*/ void main() {}', 2, 34],
    ['a missing quote', '/*{ "INPUTS": [\n  { "NAME: "x" } ] }*/ void main() {}', 2, 13],
    ['a missing colon', '/*{\n "INPUTS" [] }*/ void main() {}', 2, 11],
    ['a word without quotes', '/*{\n "CREDIT": me }*/ void main() {}', 2, 12],
  ])('%s is an error at its place', (_, source, line, column) => {
    const { output, diagnostics } = readIsf(source, 'broken.fs');
    expect(output).toBeNull();
    expect(diagnostics).toMatchObject([{ code: 'SCR040', severity: 'error', line, column, file: 'broken.fs' }]);
    expect(diagnostics[0]?.message.length).toBeGreaterThan(20);
  });

  test('a license before it is passed over', () => {
    expect(readIsf('/* MIT */\n// by me\n/*{ "CREDIT": "me" }*/ void main() {}', 'x.fs')).toMatchObject({
      output: { credit: 'me' },
      diagnostics: [],
    });
  });

  test('a byte order mark before it counts for nothing', () => {
    expect(readIsf('\ufeff/*{ "CREDIT": "me" }*/ void main() {}', 'bom.fs')).toMatchObject({ output: { credit: 'me' }, diagnostics: [] });
  });

  test('the license is in a key of ours, or in comments, as people have it', () => {
    const body = '// License Creative Commons Attribution-NonCommercial-ShareAlike 3.0\nvoid main() {}';
    expect(readIsf(`/*{ "CREDIT": "me" }*/ ${body}`, 'x.fs').output?.licence).toBe('CC BY-NC-SA 3.0');
    expect(readIsf(`/*{ "LICENSE": "MIT" }*/ ${body}`, 'x.fs').output?.licence).toBe('MIT');
    expect(readIsf('/*{ "CREDIT": "me" }*/ void main() {} // a limit', 'x.fs').output?.licence).toBe('');
  });

  test('keys of our own', () => {
    const shader = read('{ "SCRIM_TITLE": "T", "SCRIM_ALPHA": "premultiplied", "SCRIM_DEPTH": "none" }');
    expect(shader).toMatchObject({ title: 'T', premultiplied: true, depth: 'none' });
    expect(problems('{ "SCRIM_ALPHA": "both" }')).toMatchObject([{ severity: 'warning' }]);
    const passes = read('{ "PASSES": [{ "TARGET": "a", "FLOAT": true, "SCRIM_HALF": true }, { "TARGET": "b", "FLOAT": true }] }').passes;
    expect(passes.map(({ float, half }) => [float, half])).toEqual([
      [true, true],
      [true, false],
    ]);
  });
});
