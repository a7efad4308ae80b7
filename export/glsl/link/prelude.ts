import type { PassTarget } from './linked-pass.ts';

/**
 * Three vertices, no attributes: draw 3 vertices as TRIANGLES. `scrim_uv` runs from (0, 0) at the bottom left of the viewport
 * to (1, 1) at its top right.
 */
export const VERTEX_SHADER = `#version 300 es
out vec2 scrim_uv;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  scrim_uv = corner;
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
`;

export const FRAGMENT_HEAD = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
in vec2 scrim_uv;
layout(location = 0) out vec4 scrim_output;`;

/**
 * Iterations that one invocation may spend on all its loops where the uniform `scrim_loopBudget` is 0. A march of 256 steps
 * through 16 octaves takes 4,096 and a blur of 61 × 61 taps 3,721, so four times that is room enough; at a probe's 16 × 16 pixels
 * it is milliseconds even on a CPU, and a whole view of endless loops is seconds instead of for ever.
 */
export const DEFAULT_LOOP_BUDGET = 16_384;

/** Uniform that holds the budget; 0, what a program starts with, means the default. */
export const LOOP_BUDGET_UNIFORM = 'scrim_loopBudget';

/** Draw buffer that a probe reads: 1 where the budget was exceeded, else 0. */
export const LOOP_PROBE_LOCATION = 1;

/**
 * The loop budget. Each round of each loop first calls `scrim_spend`; once the budget is gone it says no, so every loop ends
 * at its next round, and the invocation with them. The second output is written to nowhere in a normal draw, whose target has
 * one attachment. A probe draws the same program into an R8UI texture at `LOOP_PROBE_LOCATION` with
 * `drawBuffers([NONE, COLOR_ATTACHMENT1])`, 16 × 16 pixels or so, and reads it back: any 1 in it means that the shader's loops
 * do not end in time.
 */
export const LOOP_BUDGET_TEXT = `uniform int ${LOOP_BUDGET_UNIFORM};
layout(location = ${LOOP_PROBE_LOCATION}) out uint scrim_overrun;
int scrim_loopsLeft;
bool scrim_spend() {
  scrim_loopsLeft -= 1;
  return scrim_loopsLeft >= 0;
}`;

/**
 * How the author's colour becomes what the target holds. Clamped before alpha is multiplied in: a bright colour would outshine
 * its own alpha. A node's own buffers, and layers of files that ask for it, take the colour as it is.
 */
export function outputText(premultiplied: boolean, target: PassTarget): string {
  if (premultiplied || target.kind === 'buffer') return 'scrim_output = scrim_fragColor;';
  const clamped = target.format === 'rgba8' ? 'scrim_fragColor = clamp(scrim_fragColor, 0.0, 1.0);\n' : '';
  return `${clamped}scrim_output = vec4(scrim_fragColor.rgb * scrim_fragColor.a, scrim_fragColor.a);`;
}
