import { describeProgram } from '../../export/compiler/describe.ts';
import type { Program } from '../../export/program/program.ts';
import { CURVE_NUMBERS } from '../../nodes/kit/curve.ts';
import { GRADIENT_NUMBERS } from '../../nodes/kit/gradient.ts';

/**
 * A program as a golden: its plan in words, then every slot, resource and operation on a line of its own. Of shaders only the
 * names stand here; their texts are the linker's, and it has goldens of its own.
 */
export function programText(program: Program): string {
  const { slots, resources, operations, shaders, presentation } = program;
  const names = Object.entries(slots.params);
  const lines = [
    describeProgram(program).trimEnd(),
    '',
    '=== slots',
    ...slots.slots.map(({ type, offset }, index) => {
      const value = type === 'text' ? slots.texts[offset] : slots.numbers.slice(offset, offset + numbersIn(type));
      const named = names.filter(([, slot]) => slot === index).map(([name]) => name);
      return `${index}: ${type} at ${offset} ${JSON.stringify(value)} ${named.join(' ')}`.trimEnd();
    }),
    '=== resources',
    ...resources.map(({ id, ...rest }) => `${id} ${JSON.stringify(rest)}`),
    '=== operations',
    ...operations.map(({ id, ...rest }) => `${id} ${JSON.stringify(rest)}`),
    '=== shaders',
    ...shaders.map(({ sourceMap }, index) => `${index}: ${sourceMap?.sources.join(' ')} of ${sourceMap?.nodes.join(' ')}`),
    '=== presentation',
    JSON.stringify(presentation),
  ];
  return `${lines.join('\n')}\n`;
}

function numbersIn(type: string): number {
  if (type === 'color') return 4;
  if (type === 'curve') return CURVE_NUMBERS;
  if (type === 'gradient') return GRADIENT_NUMBERS;
  return type.startsWith('vector') ? Number(type.slice(-1)) : 1;
}
