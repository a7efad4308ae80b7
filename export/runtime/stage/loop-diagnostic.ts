import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { LOOP_BUDGET } from '../../program/loop-budget.ts';
import type { LinkedShader } from '../../program/program.ts';

/** What a probe's line means, for the author. */
export function tooManyRounds(shader: LinkedShader | undefined, line: number): Omit<Diagnostic, 'nodeId'> {
  const entry = shader?.sourceMap?.lines.find((mapped) => mapped?.[1] === line);
  const file = entry ? shader?.sourceMap?.sources[entry[0]] : undefined;
  return {
    code: 'SCR044',
    severity: 'error',
    message: `The loops do not end in time: one pixel went round more than ${LOOP_BUDGET} times, the last time here.`,
    fix: 'See that the loop ends, or let it go round less often. The preview leaves the node out until then.',
    ...(file === undefined ? {} : { file }),
    line,
    ...(entry ? { column: entry[2] } : {}),
  };
}
