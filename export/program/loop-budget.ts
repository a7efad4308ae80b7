import type { LinkedShader } from './program.ts';

/**
 * Bounded loops (design §8), an agreement between the linker, which prints them on request, and whoever draws what it printed.
 *
 * One endless loop in a fragment shader stops every page on the GPU (measured: 45 s, no lost context). So a bounded shader gives
 * each invocation a number of rounds for all its loops together; when they are spent, every loop ends at its next round.
 *
 * Its second colour output is 0, or the author's line of the loop that spent the last round, in two bytes. A normal draw has no
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
 * Loops whose text says how often they go round are not bounded up to this, the taps of a blur over 512 × 512 pixels: they end, and
 * one who counts that far means it. Beyond, a picture takes so long that no matter how surely it ends, the GPU would be given up.
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

/** The author's line that the bytes of a probe name, RGBA per pixel; null where no pixel exceeded the budget. */
export function readProbe(bytes: Uint8Array): number | null {
  for (let i = 0; i + 1 < bytes.length; i += 4) {
    const line = (bytes[i] ?? 0) + (bytes[i + 1] ?? 0) * 256;
    if (line > 0) return line;
  }
  return null;
}

/** A diagnostic of the kit's, which this folder does not know. A warning where the loops are counted, and so the picture is drawn. */
export interface TooManyRounds {
  readonly code: 'SCR044';
  readonly severity: 'error' | 'warning';
  readonly message: string;
  readonly fix: string;
  readonly file?: string;
  readonly line: number;
  readonly column?: number;
}

/** What a probe's line means, for the author. */
export function tooManyRounds(shader: LinkedShader | undefined, line: number): TooManyRounds {
  const entry = shader?.sourceMap?.lines.find((mapped) => mapped?.[1] === line);
  const file = entry ? shader?.sourceMap?.sources[entry[0]] : undefined;
  const isCounted = shader?.loops === 'counted';
  const often = `one pixel went round more than ${LOOP_BUDGET} times`;
  return {
    code: 'SCR044',
    severity: isCounted ? 'warning' : 'error',
    message: isCounted
      ? `The loops take long: ${often}, and passed that here.`
      : `The loops do not end in time: ${often}, the last time here.`,
    fix: isCounted
      ? 'It is drawn all the same, but slow devices may show few pictures a second, or none. Let it go round less often, or draw it into a smaller pass.'
      : 'See that the loop ends, or let it go round less often. The preview leaves the node out until then.',
    ...(file === undefined ? {} : { file }),
    line,
    ...(entry ? { column: entry[2] } : {}),
  };
}
