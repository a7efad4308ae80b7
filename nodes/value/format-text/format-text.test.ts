import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ParamValue } from '../../kit/definition.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(params: Readonly<Record<string, ParamValue>>) {
  const { ctx, set, reports } = fakeContext(definition, { params });
  const node = create(ctx);
  const read = () => {
    node.update({} as never);
    return ctx.outputs.result.value;
  };
  return { read, set, reports, output: ctx.outputs.result };
}

describe('value/format-text', () => {
  test.each<[string, number, string]>([
    ['{a}', 1.2, '1.20'],
    ['{a:0}', 1.5, '2'],
    ['{a:3} s', 0.1, '0.100 s'],
    ['{a:2 m}', 1.204, '1.20 m'],
    ['{a: 1 cm }', 1.204, '120.4 cm'],
    ['{a:mm}', 0.0015, '1.50 mm'],
    ['{a:1 in} = {a:2 ft}', 0.3048, '12.0 in = 1.00 ft'],
    ['{a:0°}', Math.PI / 2, '90°'],
    ['{a:0 %}', 0.25, '25 %'],
    ['{a}', -0.001, '0.00'],
    ['{a}', -1234567, '-1234567.00'],
    ['{a} m', Number.NaN, '– m'],
    ['{{a} and }', 1, '{a} and }'],
    ['no placeholder', 1, 'no placeholder'],
    ['', 1, ''],
  ])('%s of %d is %s', (template, a, text) => {
    expect(start({ template, a }).read()).toBe(text);
  });

  test('writes several numbers and a text', () => {
    const { read, reports } = start({ template: '{text}: {a:2 m} ± {b:2 m}', a: 1.2, b: 0.01, text: 'Table' });
    expect(read()).toBe('Table: 1.20 m ± 0.01 m');
    expect(reports).toEqual([]);
  });

  test('writes anew only where a digit or the text changes', () => {
    const { read, set, output } = start({ template: '{a:1}', a: 1 });
    read();
    output.value = 'kept';
    set('a', 1.04);
    expect(read()).toBe('kept');
    set('a', 1.06);
    expect(read()).toBe('1.1');
    set('text', 'other');
    expect(read()).toBe('1.1');
  });

  test('a placeholder that is not known stays, and is reported', () => {
    const { read, reports } = start({ template: '{e} {a:2 parsec}', a: 1 });
    expect(read()).toBe('{e} {a:2 parsec}');
    expect(reports).toMatchObject([{ code: 'SCR018', port: 'template', message: expect.stringContaining('{e} {a:2 parsec}') }]);
  });
});
