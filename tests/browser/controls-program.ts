import type { Program } from '../../export/program/program.ts';
import { DISC } from './page-kit.ts';

const [pass] = DISC.operations;
if (pass?.kind !== 'pass') throw new Error('The disc is one pass.');

/** A disc whose size, presence, color and green are what visitors set. */
export const LAMP: Program = {
  ...DISC,
  title: 'Lamp',
  slots: {
    numbers: [0.3, 1, 0, 0],
    texts: [],
    slots: [
      { type: 'number', offset: 0 },
      { type: 'toggle', offset: 1 },
      { type: 'number', offset: 2 },
      { type: 'number', offset: 3 },
    ],
    params: { 'size-a1.value': 0, 'on-b2.value': 1, 'mood-c3.value': 2, 'again-d4.presses': 3 },
  },
  operations: [
    {
      ...pass,
      uniforms: [
        { name: 'size', type: 'vec2', source: { builtin: 'RENDERSIZE' } },
        { name: 'radius', type: 'float', source: { slot: 0 } },
        { name: 'on', type: 'bool', source: { slot: 1 } },
        { name: 'mood', type: 'float', source: { slot: 2 } },
        { name: 'presses', type: 'float', source: { slot: 3 } },
      ],
    },
  ],
  shaders: DISC.shaders.map((shader) => ({
    ...shader,
    id: 'lamp',
    fragment: `#version 300 es
precision highp float;
uniform vec2 size;
uniform float radius;
uniform bool on;
uniform float mood;
uniform float presses;
in vec2 uv;
out vec4 color;
void main() {
  vec2 p = (uv - 0.5) * size / min(size.x, size.y);
  float a = on && length(p) < radius ? 1.0 : 0.0;
  color = vec4(mood < 0.5 ? vec3(1.0, 0.25 * presses, 0.0) : vec3(0.0, 0.25 * presses, 1.0), 1.0) * a;
}`,
  })),
  controls: [
    { node: 'size-a1', param: 'value', label: 'Size', kind: 'slider', min: 0, max: 0.5, step: 0.1, value: 0.3 },
    { node: 'on-b2', param: 'value', label: 'Light', kind: 'toggle', value: 1 },
    { node: 'mood-c3', param: 'value', label: 'Mood', kind: 'choice', options: ['Warm', 'Cold'], value: 0 },
    { node: 'again-d4', param: 'presses', label: 'Greener', kind: 'button', value: 0 },
  ],
};
