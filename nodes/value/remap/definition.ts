import { defineNode } from '../../kit/definition.ts';

/** How far the number is along the old range, and the same limited to it, as formulas. */
const ALONG = '(fromHigh == fromLow ? number >= fromLow : (number - fromLow) / (fromHigh - fromLow))';
const LIMITED = `min(max(${ALONG}, 0), 1)`;

export const definition = defineNode({
  type: 'value/remap',
  version: 1,
  title: 'Remap',
  doc: 'Maps a number from one range to another, for example a slider’s 0 to 1 to −30 to 30. Swap the ends of a range to invert it.',
  keywords: ['map', 'range', 'scale', 'fit', 'normalize', 'normalize', 'lerp', 'interpolate', 'smoothstep'],
  inputs: {},
  outputs: { result: { type: 'number', label: 'Result', doc: 'The number in the new range.' } },
  params: {
    number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'The number to map.', default: 0.5 },
    fromLow: { type: 'number', stage: 'uniform', label: 'From min', doc: 'Start of the old range.', default: 0 },
    fromHigh: {
      type: 'number',
      stage: 'uniform',
      label: 'From max',
      doc: 'End of the old range. If it equals the start, the result is a step.',
      default: 1,
    },
    toLow: { type: 'number', stage: 'uniform', label: 'To min', doc: 'Start of the new range.', default: 0 },
    toHigh: { type: 'number', stage: 'uniform', label: 'To max', doc: 'End of the new range.', default: 1 },
    clamp: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Clamp',
      doc: 'Limit the result to the new range.',
      default: true,
    },
    curve: {
      type: 'choice',
      stage: 'structure',
      label: 'Curve',
      doc: '“Linear” maps proportionally. “Smooth” eases at both ends and always stays within the new range.',
      default: 'even',
      options: [
        { value: 'even', label: 'Linear' },
        { value: 'smooth', label: 'Smooth' },
      ],
    },
  },
  computes: {
    result: {
      by: 'curve',
      of: {
        even: `toLow + (toHigh - toLow) * (clamp ? ${LIMITED} : ${ALONG})`,
        smooth: `toLow + (toHigh - toLow) * (${LIMITED} * ${LIMITED} * (3 - 2 * ${LIMITED}))`,
      },
    },
  },
  lowering: { kind: 'value' },
});
