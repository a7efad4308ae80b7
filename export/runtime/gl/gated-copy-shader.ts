import { GATE_TEXT } from '../../program/loop-budget.ts';
import type { LinkedShader } from '../../program/program.ts';
import { COPY_FRAGMENT, vertexShader } from './copy-shader.ts';

/** Copies an image as `COPY_SHADER` does, but only if the gate is open: for passes whose loops exceed their budget. */
export const GATED_COPY_SHADER: LinkedShader = {
  id: 'scrim:gated-copy',
  vertex: vertexShader(`${GATE_TEXT}\n`, 'scrim_isShut() ? vec4(2.0, 2.0, 2.0, 1.0) : vec4(viewUv * 2.0 - 1.0, 0.0, 1.0)'),
  fragment: COPY_FRAGMENT,
};
