import type { LinkedShader } from './program.ts';

/**
 * Bounded loops (docs/adr/0012): the agreement between the linker, which prints them on request, and the runtime, which draws them.
 *
 * One endless loop in a fragment shader stops every page on the GPU (measured: 45 s, no lost context). So a bounded shader gives
 * each invocation a number of iterations for all its loops together; when they are spent, every loop ends at its next iteration.
 *
 * Its second color output is 0, or the author's line of the loop that spent the last round, in two bytes. A normal draw has no
 * attachment for it. A probe draws the same shader, with the same inputs and its usual `RENDERSIZE`, into `PROBE_SIDE_PX` squared
 * pixels of an RG8 texture at `PROBE_ATTACHMENT`, before the picture is drawn: what is endless anywhere but in a few pixels is
 * endless there.
 *
 * Where the text itself says that all loops end within `COUNTED_BUDGET` rounds, nothing is cut short and no gate is there: the
 * probe only tells of those beyond `LOOP_BUDGET`. Within that, nothing of all this is printed.
 *
 * Its vertex shader can look at the probe's texture and draw nothing where the budget was exceeded: so the picture waits for
 * no answer, and not one frame of an endless loop is drawn in full.
 */

/**
 * Rounds that one invocation may spend. A march of 256 steps through 16 octaves takes 4,096 and a blur of 61 × 61 taps 3,721,
 * so four times that is room enough; in a probe it is milliseconds even on a CPU.
 */
export const LOOP_BUDGET = 16_384;

/**
 * Loops whose text states their number of iterations are not bounded up to this total, the taps of a blur over 512 × 512 pixels:
 * they end, and so high a number is intended. Beyond it, a draw takes so long that the browser resets the GPU before it ends.
 */
export const COUNTED_BUDGET = 262_144;

/** `int`: another budget; 0, what a GL program starts with, stands for `LOOP_BUDGET`. Bounded shaders alone have it. */
export const LOOP_BUDGET_UNIFORM = 'scrim_loopBudget';

export const PROBE_ATTACHMENT = 1;
export const PROBE_SIDE_PX = 16;

/** `int`: 0 draws in any case, 1 only where the probe is all zero, 2 only where it is not. */
export const GATE_UNIFORM = 'scrim_gate';
export const GATE_SAMPLER = 'scrim_probe';

/** For a vertex shader of full-screen triangles: with `scrim_isShut()` all its corners belong into one point. */
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
 */
export function readProbe(bytes: Uint8Array): number | null {
  for (let i = 0; i + 1 < bytes.length; i += 4) {
    const line = (bytes[i] ?? 0) + (bytes[i + 1] ?? 0) * 256;
    if (line > 0) return line;
  }
  return null;
}

/** A diagnostic (SCR044). A warning where the loops are counted, because these are drawn in full. */
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
