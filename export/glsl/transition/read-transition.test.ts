import { describe, expect, test } from '@jest/globals';
import { readDefinition } from '../read-definition.ts';
import { readTransition } from './read-transition.ts';

const WIPE = `// Author: Ann
// License: MIT
uniform float softness; // = 0.25
uniform ivec2 size; // = ivec2(10, 4)
uniform vec2 center /* = vec2(0.5) */;
uniform vec3 burnColor; // = vec3(0.9, 0.4, 0.2)
uniform vec4 border_color; // = vec4(1.0)
uniform vec4 steps; // = vec4(0.0, 0.2, -0.4, 1.0)
uniform bool reversed; // = true
uniform int count; // = 30 bars
uniform float silent;
uniform sampler2D map;
uniform float progress;
uniform float ratio;
vec4 transition(vec2 uv) { return mix(getFromColor(uv), getToColor(uv), progress); }
`;

describe('a transition', () => {
  test('has two layers, progress, and its uniforms with their first values', () => {
    const { output, diagnostics } = readTransition(WIPE, 'shaders/wipe.glsl');
    expect(diagnostics).toEqual([]);
    expect(output).toMatchObject({ kind: 'operator', credit: 'Ann', licence: 'MIT', dialect: 'transition' });
    expect(output?.inputs.map(({ name, type, default: start }) => [name, type, start])).toEqual([
      ['startImage', 'image', []],
      ['endImage', 'image', []],
      ['progress', 'float', [0]],
      ['softness', 'float', [0.25]],
      ['size', 'point2D', [10, 4]],
      ['center', 'point2D', [0.5, 0.5]],
      ['burnColor', 'color', [0.9, 0.4, 0.2, 1]],
      ['border_color', 'color', [1, 1, 1, 1]],
      ['steps', 'vector4', [0, 0.2, -0.4, 1]],
      ['reversed', 'bool', [1]],
      ['count', 'long', [30]],
      ['silent', 'float', [0]],
      ['map', 'image', []],
    ]);
  });

  test('is an operator where a technique is a technique', () => {
    const { output } = readDefinition(WIPE, 'shaders/wipe.glsl');
    expect(output).toMatchObject({
      type: 'operator/wipe',
      credit: 'Ann',
      licence: 'MIT',
      lowering: { kind: 'image', access: 'pointwise' },
    });
    expect(Object.keys(output?.inputs ?? {})).toEqual(['startImage', 'endImage', 'map']);
    expect(output?.params.progress).toMatchObject({ type: 'number', min: 0, max: 1, default: 0 });
    expect(output?.params.steps).toMatchObject({ type: 'vector4' });
    const technique = '/*{ "DESCRIPTION": "A transition from cool to warm." }*/\nvec4 surface(const in Surface s) { return vec4(1.0); }';
    expect(readDefinition(technique, 'shaders/gooch.glsl').output?.type).toBe('technique/gooch');
  });

  test('that cannot be read says where, and a uniform of a type without a param is told', () => {
    expect(readTransition('vec4 transition(vec2 uv) { return vec4(1.0) }', 'a.glsl')).toMatchObject({
      output: null,
      diagnostics: [{ code: 'SCR041', file: 'a.glsl', line: 1 }],
    });
    const { diagnostics } = readTransition('uniform mat2 turn;\nvec4 transition(vec2 uv) { return vec4(1.0); }', 'a.glsl');
    expect(diagnostics).toMatchObject([{ code: 'SCR043', severity: 'warning', line: 1, column: 14 }]);
  });
});
