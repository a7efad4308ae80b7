import { expect, test } from '@jest/globals';
import type { FlatNode } from '../../export/compiler/flat-graph.ts';
import { constantsOf } from '../../export/compiler/fold/constants.ts';
import { DEFINITIONS } from '../../nodes/generated/definitions.gen.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { NodeDefinition, ParamDefinition, ParamValue } from '../../nodes/kit/definition.ts';
import { fakeContext } from '../support/node-context.ts';

const COMPUTED = DEFINITIONS.filter(({ computes }) => computes !== undefined);

/** Numbers on both sides of 0 and of the limits of switches, equal ones too. */
const NUMBERS = [-2.5, -1, -0.25, 0, 0.5, 0.5, 1, 1.5, 2.6, 7];

function chosenValue(param: ParamDefinition, round: number, place: number): ParamValue {
  const number = NUMBERS[(round * 3 + place * 7 + round * place) % NUMBERS.length] ?? 0;
  switch (param.type) {
    case 'number':
      return Math.max(number, param.min ?? number);
    case 'toggle':
      return number > 0;
    case 'choice':
      return param.options[round % param.options.length]?.value ?? param.default;
    case 'color':
      return round % 4 === 0
        ? [0.4, 0.4, 0.4, 0]
        : [0.25, 0.5, 0.75, 1].map((channel, i) => (channel * (1 + ((round + place + i) % 5))) / 5);
    case 'vector2':
      return [number, round];
    case 'vector3':
      return [number, round, -number];
    case 'vector4':
      return [number, round, -number, place];
    case 'text':
      return param.expression ? 'a * 2 + max(b, c) / d' : param.default;
    default:
      return param.default;
  }
}

/** The outputs of the node's own runtime after one frame. */
function played(definition: NodeDefinition, params: Readonly<Record<string, ParamValue>>): Record<string, unknown> {
  const runtime = RUNTIMES[definition.type];
  if (!runtime || !('create' in runtime)) throw new Error(`There is no runtime for ${definition.type}.`);
  // The compiler prints expressions in postfix notation.
  const config = definition.type === 'value/expression' ? { ...params, expression: 'a 2 * b c max d / +' } : params;
  const { ctx } = fakeContext(definition, { params: config as never });
  runtime.create(ctx as never).update({} as never);
  return Object.fromEntries(Object.entries(ctx.outputs).map(([port, output]) => [port, (output as { value: unknown }).value]));
}

test.each(COMPUTED.map((definition) => [definition.type, definition] as const))(
  'the compiler computes what %s outputs',
  (_, definition) => {
    for (let round = 0; round < 60; round++) {
      const params = Object.fromEntries(Object.entries(definition.params).map(([name, param], i) => [name, chosenValue(param, round, i)]));
      const bindings = new Map(Object.entries(params).map(([name, value]) => [name, { value }]));
      const node: FlatNode = { id: 'n', definition, unfused: false, inputs: new Map(), bindings, muteBlocked: new Map() };
      const outputs = played(definition, params);
      expect(Object.fromEntries(constantsOf(node))).toEqual(
        Object.fromEntries(
          Object.entries(outputs).map(([port, value]) => [port, typeof value === 'object' ? [...(value as number[])] : value]),
        ),
      );
    }
  },
);

test('values that depend on time, chance or what a visitor does are not among them', () => {
  expect(COMPUTED.filter(({ inputs, control, delay, stateful }) => control || delay || stateful || Object.keys(inputs).length > 0)).toEqual(
    [],
  );
  expect(COMPUTED.map(({ type }) => type)).not.toContain('value/random');
});
