import type { LinkedShader } from './program.ts';

/**
 * Bounded loops (docs/adr/0012): the contract between the linker, which adds the budget on request, and the runtime, which probes shaders.
 *
 * One endless loop in a fragment shader blocks every page that uses the GPU (measured: 45 s without a lost context). A bounded shader
 * therefore limits the iterations of each invocation, over all its loops together; when they are used up, every loop ends at its next
 * iteration.
 *
 * Its second color output is 0, or the author's line of the loop that exceeded the budget, in two bytes. A normal draw has no attachment
 * for it. A probe draws the same shader with the same inputs and `RENDERSIZE` to `PROBE_SIDE_PX` squared pixels of an RG8 texture at
 * `PROBE_ATTACHMENT` before the actual draw. A loop that is endless in more than a few pixels is endless there.
 *
 * If the text shows that all loops end within `COUNTED_BUDGET` iterations, they are not bounded and the gate is left out; the probe then
 * only reports loops beyond `LOOP_BUDGET`. Within that, nothing is added to the shader.
 *
 * The vertex shader can read the probe's texture and draw nothing if the budget was exceeded. So the draw needs no readback, and no frame
 * of an endless loop is drawn in full.
 */

/**
 * Iterations of one invocation. Ray marching of 256 steps through 16 octaves takes 4,096, a blur of 61 × 61 samples 3,721; four times that
 * is ample and takes milliseconds in a probe even on a CPU.
 */
export const LOOP_BUDGET = 16_384;

/**
 * Maximum number of iterations of loops that are not bounded, because the text states how many they have: that of a blur over 512 × 512
 * pixels. Such loops end, and the number is intended. Beyond it, a draw takes so long that the browser resets the GPU.
 */
export const COUNTED_BUDGET = 262_144;

/** Name of the `int` uniform that sets the budget of a bounded shader; 0, the initial value in GL, means `LOOP_BUDGET`. */
export const LOOP_BUDGET_UNIFORM = 'scrim_loopBudget';

export const PROBE_ATTACHMENT = 1;
export const PROBE_SIDE_PX = 16;

/**
 * Name of the `int` uniform that decides whether a bounded shader draws: 0 always draws, 1 draws only if the probe is all zero, 2 only if
 * it is not.
 */
export const GATE_UNIFORM = 'scrim_gate';
export const GATE_SAMPLER = 'scrim_probe';

/** GLSL for the vertex shader of full-screen triangles. If `scrim_isShut()` is true, all vertices must have the same position. */
export const GATE_TEXT = `uniform int ${GATE_UNIFORM};
uniform highp sampler2D ${GATE_SAMPLER};
bool scrim_isShut() {
  if (${GATE_UNIFORM} == 0) return false;
  bool exceeded = false;
  for (int i = 0; i < ${PROBE_SIDE_PX ** 2}; i++) {
    vec2 line = texelFetch(${GATE_SAMPLER}, ivec2(i % ${PROBE_SIDE_PX}, i / ${PROBE_SIDE_PX}), 0).rg;
    exceeded = exceeded || line != vec2(0.0);
  }
  return exceeded == (${GATE_UNIFORM} == 1);
}`;

/**
 * Reads a probe.
 *
 * @param bytes RGBA, four bytes per pixel.
 * @returns The author's line that exceeded the budget, from 1, or null where no pixel did.
 * @example
 * readProbe(Uint8Array.of(0, 0, 0, 0, 12, 0, 0, 0)); // 12
 */
export function readProbe(bytes: Uint8Array): number | null {
  for (let i = 0; i + 1 < bytes.length; i += 4) {
    const line = (bytes[i] ?? 0) + (bytes[i + 1] ?? 0) * 256;
    if (line > 0) return line;
  }
  return null;
}

/** A diagnostic (SCR044). It is a warning for counted loops, because these are drawn in full. */
export interface TooManyIterations {
  readonly code: 'SCR044';
  readonly severity: 'error' | 'warning';
  readonly message: string;
  readonly fix: string;
  readonly file?: string;
  readonly line: number;
  readonly column?: number;
}

/**
 * Describes an exceeded loop budget as a diagnostic.
 *
 * @param line The author's line, from `readProbe`.
 *
 * @example
 * const line = readProbe(bytes);
 * if (line !== null) report(tooManyIterations(shader, line));
 */
export function tooManyIterations(shader: LinkedShader | undefined, line: number): TooManyIterations {
  const entry = shader?.sourceMap?.lines.find((mapped) => mapped?.[1] === line);
  const file = entry ? shader?.sourceMap?.sources[entry[0]] : undefined;
  const isCounted = shader?.loops === 'counted';
  const often = `one pixel ran more than ${LOOP_BUDGET} iterations`;
  return {
    code: 'SCR044',
    severity: isCounted ? 'warning' : 'error',
    message: isCounted
      ? `The loops take long: ${often}, and passed that limit here.`
      : `The loops do not end in time: ${often}, the last time here.`,
    fix: isCounted
      ? 'Reduce the iterations, or draw into a smaller pass. Slow devices may have a low frame rate or show nothing.'
      : 'Make the loop end, or reduce its iterations. The preview leaves the node out until then.',
    ...(file === undefined ? {} : { file }),
    line,
    ...(entry ? { column: entry[2] } : {}),
  };
}
