import { describe, expect, test } from '@jest/globals';
import { readShader, TEST_LIBRARY } from '../../tests/support/test-library.ts';
import { TestStudio } from '../../tests/support/test-studio.ts';
import { canConnect } from './can-connect.ts';
import { parseWire } from './wires.ts';

const studio = new TestStudio({ library: TEST_LIBRARY, readShader })
  .add('video-aaaa', 'source/camera-video')
  .add('sepia-aaaa', 'filter/sepia')
  .add('sepia-bbbb', 'filter/sepia')
  .add('model-aaaa', 'source/model')
  .add('group-aaaa', 'objects/group')
  .add('color-aaaa', 'value/color')
  .add('toggle-aaaa', 'value/toggle')
  .add('number-aaaa', 'value/number')
  .add('box-aaaa', 'objects/primitive')
  .add('sum-aaaa', 'value/math')
  .add('delay-aaaa', 'value/delay')
  .add('delay-bbbb', 'value/delay')
  .wire(
    'video-aaaa.layer -> sepia-aaaa.inputImage',
    'sepia-aaaa.layer -> sepia-bbbb.inputImage',
    'model-aaaa.objects -> group-aaaa.objects',
    'delay-aaaa.value -> sum-aaaa.a',
    'sum-aaaa.result -> delay-bbbb.value',
  )
  .mute('delay-bbbb')
  .bind('sepia-bbbb.amount', { expression: 'time' });

function ask(text: string) {
  const wire = parseWire(text);
  if (!wire) throw new Error(text);
  return canConnect(studio.project, studio.library, 'main', wire.from, wire.to);
}

describe('canConnect', () => {
  test.each([
    ['the same type', 'video-aaaa.layer -> sepia-bbbb.inputImage', 'same'],
    ['a number to a param', 'number-aaaa.value -> sepia-aaaa.amount', 'same'],
    ['a toggle to a number', 'toggle-aaaa.value -> sepia-aaaa.amount', 'lossless'],
    ['a loop through a delay', 'sum-aaaa.result -> delay-aaaa.value', 'same'],
    ['a delay of its own', 'delay-aaaa.value -> delay-aaaa.value', 'same'],
    ['another wire to a port for several', 'box-aaaa.objects -> group-aaaa.objects', 'same'],
  ])('allows %s', (_, wire, conversion) => {
    expect(ask(wire)).toEqual({ ok: true, conversion });
  });

  test.each([
    ['another type', 'model-aaaa.objects -> sepia-aaaa.inputImage', 'SCR013', '“Objects”, but sepia-aaaa.inputImage takes “Layer”'],
    ['a lossy conversion', 'color-aaaa.color -> sepia-aaaa.amount', 'SCR013', '“Color”'],
    ['a loop', 'sepia-bbbb.layer -> sepia-aaaa.inputImage', 'SCR014', 'sepia-bbbb → sepia-aaaa → sepia-bbbb'],
    ['a node to itself', 'sepia-bbbb.layer -> sepia-bbbb.inputImage', 'SCR014', 'sepia-bbbb → sepia-bbbb'],
    ['a loop through a delay that is muted', 'delay-bbbb.value -> sum-aaaa.b', 'SCR014', 'delay-bbbb → sum-aaaa → delay-bbbb'],
    ['an unknown node', 'video-aaaa.layer -> nothing-aaaa.layer', 'SCR012', 'Node nothing-aaaa does not exist'],
    ['an unknown port', 'video-aaaa.sound -> sepia-aaaa.inputImage', 'SCR012', 'no output “sound”; it has layer'],
    ['a name that every object has', 'video-aaaa.constructor -> sepia-aaaa.inputImage', 'SCR012', 'no output'],
    ['the wrong way round', 'sepia-aaaa.inputImage -> sepia-bbbb.layer', 'SCR012', 'from an output to an input'],
    ['a param that is fixed', 'number-aaaa.value -> box-aaaa.shape', 'SCR019', 'fixed'],
    ['a param with an expression', 'number-aaaa.value -> sepia-bbbb.amount', 'SCR019', 'follows an expression'],
    ['the same wire again', 'model-aaaa.objects -> group-aaaa.objects', 'SCR016', 'already'],
  ])('refuses %s and says why', (_, wire, code, words) => {
    const answer = ask(wire);
    if (answer.ok) throw new Error('allowed');
    expect(answer.reason).toMatchObject({ code, severity: 'error' });
    expect(answer.reason.message).toContain(words);
  });

  test('answers about every port of 3,000 nodes while a wire is dragged', () => {
    const nodes = Object.fromEntries(Array.from({ length: 3000 }, (_, i) => [`s-${i}`, { type: 'filter/sepia', version: 1, params: {} }]));
    const wires = Array.from({ length: 2999 }, (_, i) => ({
      from: { node: `s-${i}`, port: 'layer' },
      to: { node: `s-${i + 1}`, port: 'inputImage' },
    }));
    const main = { nodes, wires, exposed: { inputs: [], outputs: [] } };
    const project = { ...studio.project, graphs: { main } };
    const last = canConnect(project, studio.library, 'main', { node: 's-2999', port: 'layer' }, { node: 's-0', port: 'inputImage' });
    expect(last.ok).toBe(false);
    // Were each answer to take time for every pair of nodes, the test would not end.
    const answers = Array.from({ length: 300 }, (_, i) =>
      canConnect(project, studio.library, 'main', { node: 's-0', port: 'layer' }, { node: `s-${i * 10 + 2}`, port: 'inputImage' }),
    );
    expect(answers.filter(({ ok }) => ok)).toHaveLength(300);
  });
});
