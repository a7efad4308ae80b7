import { GATE_TEXT, LOOP_BUDGET, LOOP_BUDGET_UNIFORM, PROBE_ATTACHMENT } from '../../program/loop-budget.ts';
import type { PassTarget } from './linked-pass.ts';

/**
 * Vertex shader of a full-screen triangle without attributes: draw 3 vertices as TRIANGLES. `scrim_uv` is (0, 0) at the bottom left of the
 * viewport and (1, 1) at its top right.
 */
export const VERTEX_SHADER = vertexShader('', 'vec4(corner * 2.0 - 1.0, 0.0, 1.0)');

/** `VERTEX_SHADER` with a gate: while the gate is shut (`GATE_TEXT`), the shader draws nothing. */
export const BOUNDED_VERTEX_SHADER = vertexShader(
  `${GATE_TEXT}\n`,
  'scrim_isShut() ? vec4(2.0, 2.0, 2.0, 1.0) : vec4(corner * 2.0 - 1.0, 0.0, 1.0)',
);

function vertexShader(declarations: string, position: string): string {
  return `#version 300 es
out vec2 scrim_uv;
${declarations}void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  scrim_uv = corner;
  gl_Position = ${position};
}
`;
}

/**
 * Text before an author's vertex shader. `scrim_uv` is that of `VERTEX_SHADER`; `normCoord` contains `isf_FragNormCoord`. The
 * initialization functions that authors call are empty: `vertexMain` has set these values before.
 */
export function vertexHead(normCoord: string): string {
  return `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
out vec2 scrim_uv;
out vec2 ${normCoord};
void isf_vertShaderInit() {}
void vv_vertShaderInit() {}`;
}

/** Prints a `main` that calls the author's `main` (`author`) for the corners 0, 1, 2 and 3, 2, 1: from the bottom left along x, then up. */
export function vertexMain(author: string, normCoord: string, isBounded: boolean): string {
  return `void main() {
  int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID;
  ${normCoord} = vec2(corner & 1, corner >> 1);
  gl_Position = vec4(${normCoord} * 2.0 - 1.0, 0.0, 1.0);
  scrim_start();
  ${author}();
  scrim_uv = gl_Position.xy / gl_Position.w * 0.5 + 0.5;${isBounded ? '\n  if (scrim_isShut()) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);' : ''}
}`;
}

export const FRAGMENT_HEAD = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
in vec2 scrim_uv;
layout(location = 0) out vec4 scrim_output;`;

/**
 * Bounds the loops of a text (`export/program/loop-budget.ts`). Each iteration of each loop first calls `scrim_spend`; when the budget is
 * used up, `scrim_spend` returns false, so every loop ends before its next iteration, and the invocation ends soon.
 */
export const LOOP_BUDGET_TEXT = `uniform int ${LOOP_BUDGET_UNIFORM};
layout(location = ${PROBE_ATTACHMENT}) out vec2 scrim_overrun;
int scrim_roundsLeft;
int scrim_endlessLine = 0;
bool scrim_spend(int line) {
  scrim_roundsLeft -= 1;
  if (scrim_roundsLeft >= 0) return true;
  if (scrim_endlessLine == 0) scrim_endlessLine = line;
  return false;
}`;

/** `LOOP_BUDGET_TEXT` for loops that are known to end: exceeding the budget is reported, and they continue. */
export const COUNTED_LOOPS_TEXT = LOOP_BUDGET_TEXT.replace('return false', 'return true');

export const LOOP_BUDGET_START = `scrim_roundsLeft = ${LOOP_BUDGET_UNIFORM} > 0 ? ${LOOP_BUDGET_UNIFORM} : ${LOOP_BUDGET};`;
export const LOOP_BUDGET_END = 'scrim_overrun = vec2(scrim_endlessLine & 255, scrim_endlessLine >> 8) / 255.0;';

/**
 * Prints the call that is the condition of a loop's next iteration. Lines above 65,535 are reported as 65,535, because two bytes encode the
 * line.
 */
export function spend(line: number): string {
  return `scrim_spend(${Math.min(line, 0xffff)})`;
}

/**
 * GLSL functions that replace NaN by 0, clamp numbers to the range of half floats and alpha to [0, 1]. One NaN would spread with each blur.
 * Bits are compared, because drivers optimize `isnan` away.
 */
export const FINITE_TEXT = `float scrim_finite(float x) {
  return (floatBitsToUint(x) & 0x7FFFFFFFu) > 0x7F800000u ? 0.0 : clamp(x, -65504.0, 65504.0);
}
vec4 scrim_finite(vec4 color) {
  return vec4(scrim_finite(color.r), scrim_finite(color.g), scrim_finite(color.b), clamp(scrim_finite(color.a), 0.0, 1.0));
}`;

/** How the author's color becomes the content of a target: statements that change `scrim_fragColor`, and the color to store. */
export interface Output {
  readonly statements: readonly string[];
  readonly color: string;
  /** Whether the statements clamp the straight color to [0, 1], and `color` is that color, premultiplied. */
  readonly clamps: boolean;
}

/**
 * Converts the author's color to the content of the target. The color of a display layer is clamped before premultiplication, because
 * bright colors would exceed their alpha; in scene layers, colors may exceed it. The node's own buffers, and layers of premultiplied files,
 * get the color as it is.
 */
export function outputOf(premultiplied: boolean, target: PassTarget): Output {
  const multiplied = 'vec4(scrim_fragColor.rgb * scrim_fragColor.a, scrim_fragColor.a)';
  if (target.format === 'scene16f') {
    const color = premultiplied ? 'scrim_fragColor' : multiplied;
    return { statements: ['scrim_fragColor = scrim_finite(scrim_fragColor);'], color, clamps: false };
  }
  if (premultiplied || target.kind === 'buffer') return { statements: [], color: 'scrim_fragColor', clamps: false };
  if (target.format !== 'rgba8') return { statements: [], color: multiplied, clamps: false };
  return { statements: ['scrim_fragColor = clamp(scrim_fragColor, 0.0, 1.0);'], color: multiplied, clamps: true };
}

/** Prints the statements that store the author's color. */
export function outputText({ statements, color }: Pick<Output, 'statements' | 'color'>): string {
  return [...statements, `scrim_output = ${color};`].join('\n');
}
