import { describe, expect, test } from '@jest/globals';
import type { LinkedShader } from '../../program/program.ts';
import { driverDiagnostics } from './driver-diagnostics.ts';

const SOURCE = '/*{}*/\nfloat f() { return 1.0; }\nvoid main() {\n  gl_FragColor = vec4(tint, f(2.0),\n    tint);\n}';

/** Printed lines 3 and 4 are the author's lines 4 and 5. */
const LINKED: LinkedShader = {
  id: 'x',
  vertex: '',
  fragment: '',
  sourceMap: { sources: ['my.fs'], nodes: ['my-n0de'], lines: [null, null, [0, 4, 3], [0, 5, 5]] },
};

const sourceOf = () => SOURCE;

describe('a driver’s log', () => {
  test('of ANGLE, with what it quotes', () => {
    const log =
      "ERROR: 0:3: 'tint' : undeclared identifier\nERROR: 0:4: 'tint' : undeclared identifier\nERROR: 0:3: 'a_f' : no matching overloaded function found\n\0";
    expect(driverDiagnostics(LINKED, log, sourceOf)).toEqual([
      {
        code: 'SCR042',
        severity: 'error',
        nodeId: 'my-n0de',
        file: 'my.fs',
        line: 4,
        column: 23,
        message: '"tint": undeclared identifier.',
        fix: 'Check its spelling, capitals included, or declare it above.',
      },
      {
        code: 'SCR042',
        severity: 'error',
        nodeId: 'my-n0de',
        file: 'my.fs',
        line: 4,
        column: 29,
        message: '"f": no matching overloaded function found.',
        fix: 'Check the number and types of the arguments.',
      },
    ]);
  });

  test('of a name that is not declared, where it first stands, and without what follows from it', () => {
    const source =
      '/*{}*/\nvoid main() {\n  vec3 c = tint.rgb;\n  c += tint * f(1.0) + c.q;\n  float d = vec2(1.0); float e = vec3(2.0);\n}';
    const linked = {
      ...LINKED,
      sourceMap: {
        sources: ['my.fs'],
        nodes: [''],
        lines: [
          [0, 5, 11],
          [0, 5, 24],
          [0, 3, 3],
          [0, 4, 3],
        ],
      },
    } as const;
    const log = [
      "ERROR: 0:1: '=' : dimension mismatch",
      "ERROR: 0:1: 'assign' : cannot convert from 'const 2-component vector of float' to 'highp float'",
      "ERROR: 0:2: '=' : cannot convert from 'const 3-component vector of float' to 'highp float'",
      "ERROR: 0:3: 'tint' : undeclared identifier",
      "ERROR: 0:3: 'rgb' :  field selection requires structure, vector, or interface block on left hand side",
      "ERROR: 0:3: '=' : cannot convert from 'const float' to 'highp 3-component vector of float'",
      "ERROR: 0:4: 'tint' : undeclared identifier",
      "ERROR: 0:4: 'q' : illegal vector field selection",
      "ERROR: 0:4: 'f' : no matching overloaded function found",
    ].join('\n');
    const told = driverDiagnostics(linked, log, () => source);
    expect(told.map(({ line, column, message }) => [line, column, message])).toEqual([
      [3, 12, '"tint": undeclared identifier.'],
      [4, 15, '"f": no matching overloaded function found.'],
      [5, 11, '"=": cannot convert from vec2 to float.'],
      [5, 32, '"=": cannot convert from vec3 to float.'],
    ]);
  });

  test.each([
    [
      "'*' : wrong operand types - no operation '*' exists that takes a left-hand operand of type 'structure 'a_Ray' (symbol id 3004)' and a right operand of type 'const 3X3 matrix of float' (or there is no acceptable conversion)",
      'wrong operand types: Ray and mat3 cannot be combined.',
    ],
    [
      "'=' : cannot convert from 'array[3] of mediump 2-component vector of int' to 'uniform 4X2 matrix of float'",
      'cannot convert from ivec2[3] to mat4x2.',
    ],
  ])('in the author’s words: %s', (line, wanted) => {
    expect(driverDiagnostics(LINKED, `ERROR: 0:3: ${line}`)[0]?.message).toMatch(new RegExp(`: ${wanted.replace(/[[\].]/g, '\\$&')}$`));
  });

  test('of Mesa', () => {
    expect(driverDiagnostics(LINKED, "0:4(17): error: `tint' undeclared", sourceOf)).toMatchObject([
      { line: 5, column: 5, severity: 'error' },
    ]);
  });

  test('without the author’s text, at the start of the statement', () => {
    expect(driverDiagnostics(LINKED, "ERROR: 0:3: 'tint' : undeclared identifier")).toMatchObject([{ line: 4, column: 3 }]);
  });

  test('without a source map, as in an export, or on a line of the linker’s own, it still speaks', () => {
    const { sourceMap: _, ...bare } = LINKED;
    expect(driverDiagnostics(bare, "ERROR: 0:3: 'x' : bad")).toEqual([{ code: 'SCR042', severity: 'error', message: '"x": bad' }]);
    expect(driverDiagnostics(LINKED, "ERROR: 0:1: 'x' : bad")).toEqual([
      { code: 'SCR042', severity: 'error', nodeId: 'my-n0de', file: 'my.fs', message: '"x": bad' },
    ]);
  });

  test('of a kind that nobody has seen is passed on, once; nothing gives nothing', () => {
    expect(driverDiagnostics(LINKED, 'internal compiler failure\nmore')).toMatchObject([{ message: 'internal compiler failure' }]);
    expect(driverDiagnostics(LINKED, "ERROR: 0:3: 'x' : bad\nERROR: 0:3: 'x' : bad")).toHaveLength(1);
    expect(driverDiagnostics(LINKED, '')).toEqual([]);
    expect(driverDiagnostics(LINKED, '\0\n')).toEqual([]);
  });

  test('warnings stay warnings', () => {
    expect(driverDiagnostics(LINKED, "WARNING: 0:3: 'tint' : unused", sourceOf)).toMatchObject([{ severity: 'warning' }]);
  });
});
