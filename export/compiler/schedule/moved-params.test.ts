import { describe, expect, test } from '@jest/globals';
import { ids, passes, program } from '../../../tests/compile/compiled.ts';
import { emptyStudio, sceneStudio, videoStudio } from '../../../tests/compile/graphs.ts';
import { programFaults } from '../../../tests/compile/program-faults.ts';
import { TEST_LIBRARY as library } from '../../../tests/support/test-library.ts';
import type { TestStudio } from '../../../tests/support/test-studio.ts';
import type { Binding } from '../../graph/project.ts';
import type { NodeOperation, Program } from '../../program/program.ts';
import { compile } from '../compile.ts';

const sepia = (binding: Binding) =>
  videoStudio()
    .add('sepia-a', 'filter/sepia')
    .wire('video-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer')
    .bind('sepia-a.amount', binding);

function operation(made: Program, id: string): NodeOperation {
  const found = made.operations.find((candidate) => candidate.id === id);
  if (found?.kind !== 'value') throw new Error(`There is no ${id}.`);
  return found;
}

function told(studio: TestStudio) {
  const { output, diagnostics } = compile({ project: studio.project, library });
  expect(output).toBeNull();
  return diagnostics;
}

const UP: Binding = {
  track: {
    keys: [
      { timeS: 0, value: -3, easing: 'ease-in' },
      { timeS: 2, value: 0.5, easing: 'step' },
    ],
    repeat: 'mirror',
  },
};

describe('a param bound to an expression', () => {
  test('is computed each frame, within its limits, before the pass that reads it', () => {
    const made = program(sepia({ expression: '2 * sin(time)' }));
    const computed = operation(made, 'sepia-a.amount.expression');
    expect(computed).toMatchObject({
      node: 'sepia-a',
      type: 'binding/expression',
      view: 'once',
      config: { postfix: '2 time sin * 0 max 1 min', otherwise: [1] },
    });
    expect(passes(made)[0]?.uniforms[0]?.source).toEqual({ slot: computed.outputs.value?.kind === 'slot' && computed.outputs.value.slot });
    expect(programFaults(made)).toEqual([]);
  });

  test('cannot be set by hand, because the next frame would undo it', () => {
    expect(Object.keys(program(sepia({ expression: 'time' })).slots.params)).not.toContain('sepia-a.amount');
  });

  test('comes before values that read it', () => {
    const studio = emptyStudio()
      .add('video-a', 'source/camera-video')
      .add('math-a', 'value/math')
      .add('sepia-a', 'filter/sepia')
      .add('screen-a', 'output/screen')
      .wire('video-a.layer -> sepia-a.inputImage', 'math-a.result -> sepia-a.amount', 'sepia-a.layer -> screen-a.layer')
      .bind('math-a.a', { expression: 'frame / 10' });
    expect(ids(program(studio), 'value')).toEqual(['math-a.a.expression', 'math-a']);
  });

  test('is a list where the param holds several numbers', () => {
    const moved = (expression: string) =>
      sceneStudio()
        .wire('video-a.layer -> over-a.bottom')
        .add('place-a', 'objects/transform')
        .wire('box-a.objects -> place-a.objects', 'place-a.objects -> scene-a.objects')
        .unwire('box-a.objects -> scene-a.objects')
        .bind('place-a.position', { expression });
    expect(operation(program(moved('[sin(time), 0, -2]')), 'place-a.position.expression').config).toEqual({
      postfix: 'time sin 0 2 negate',
      otherwise: [0, 0, 0],
    });
    expect(told(moved('time'))).toMatchObject([{ code: 'SCR022', nodeId: 'place-a', port: 'position', column: 1 }]);
  });

  test('that cannot be read is told with node, param and column, and in words', () => {
    const [diagnostic] = told(sepia({ expression: '1 + sine(time)' }));
    expect(diagnostic).toMatchObject({ code: 'SCR022', severity: 'error', nodeId: 'sepia-a', port: 'amount', column: 5 });
    expect(diagnostic?.message).toMatch(
      /^The expression of “amount” of sepia-a cannot be read: Unknown function “sine”; use one of sin, cos, .*, smoothstep \(character 5\)\.$/,
    );
  });

  test('moves an opacity that blending would otherwise stand for', () => {
    const faded = sceneStudio().wire('video-a.layer -> over-a.bottom').bind('over-a.opacity', { expression: 'time' });
    expect(passes(program(faded)).map(({ id }) => id)).toEqual(['over-a.pass0']);
  });

  test('within a subgraph, and from outside of it', () => {
    const studio = emptyStudio()
      .in('look')
      .add('sepia-a', 'filter/sepia')
      .bind('sepia-a.amount', { expression: 'time' })
      .expose('inputs', 'picture', 'sepia-a.inputImage')
      .expose('inputs', 'strength', 'sepia-a.amount')
      .expose('outputs', 'layer', 'sepia-a.layer')
      .in('main')
      .add('video-a', 'source/camera-video')
      .add('look-a', 'graph/look')
      .add('look-b', 'graph/look')
      .add('screen-a', 'output/screen')
      .wire('video-a.layer -> look-a.picture', 'look-a.layer -> look-b.picture', 'look-b.layer -> screen-a.layer')
      .bind('look-b.strength', { expression: 'frame' });
    const made = program(studio);
    expect(operation(made, 'look-a/sepia-a.amount.expression').config.postfix).toContain('time');
    expect(operation(made, 'look-b/sepia-a.amount.expression').config.postfix).toContain('frame');
    const slots = passes(made).map(({ uniforms }) => uniforms[0]?.source);
    expect(slots[0]).not.toEqual(slots[1]);
  });

  test('gives way to a wire from outside the subgraph', () => {
    const studio = emptyStudio()
      .in('look')
      .add('sepia-a', 'filter/sepia')
      .bind('sepia-a.amount', { expression: 'time' })
      .expose('inputs', 'picture', 'sepia-a.inputImage')
      .expose('inputs', 'strength', 'sepia-a.amount')
      .expose('outputs', 'layer', 'sepia-a.layer')
      .in('main')
      .add('video-a', 'source/camera-video')
      .add('number-a', 'value/number')
      .add('look-a', 'graph/look')
      .add('screen-a', 'output/screen')
      .wire('video-a.layer -> look-a.picture', 'number-a.value -> look-a.strength', 'look-a.layer -> screen-a.layer');
    expect(ids(program(studio), 'value')).toEqual(['number-a']);
  });
});

describe('a param bound to a track', () => {
  test('holds its keys within its limits', () => {
    expect(operation(program(sepia(UP)), 'sepia-a.amount.track')).toMatchObject({
      type: 'binding/track',
      config: { times: [0, 2], values: [0, 0.5], easings: 'ease-in step', repeat: 'mirror' },
    });
  });

  test('that overshoots has the limits of the param with it', () => {
    const keys = [
      { timeS: 0, value: 0, easing: [0.3, 0, 0.2, 1] as const },
      { timeS: 1, value: 1, easing: [0.34, 1.56, 0.64, 1] as const },
    ];
    const config = (binding: Binding) => operation(program(sepia(binding)), 'sepia-a.amount.track') as { config?: object };
    expect(config({ track: { keys, repeat: 'once' } }).config).toEqual({
      times: [0, 1],
      values: [0, 1],
      easings: '0.3,0,0.2,1 0.34,1.56,0.64,1',
      limits: [0, 1],
      repeat: 'once',
    });
    expect(config({ track: { keys: keys.slice(0, 1), repeat: 'once' } }).config).not.toHaveProperty('limits');
  });

  test('holds all numbers of a vector', () => {
    const keys = [
      { timeS: 0, value: [0, 0, 0], easing: 'linear' as const },
      { timeS: 1, value: [1, 2, 3], easing: 'linear' as const },
    ];
    const studio = sceneStudio()
      .wire('scene-a.layer -> screen-a.layer')
      .add('place-a', 'objects/transform')
      .wire('box-a.objects -> place-a.objects', 'place-a.objects -> scene-a.objects')
      .bind('place-a.position', { track: { keys, repeat: 'loop' } });
    expect(operation(program(studio), 'place-a.position.track').config.values).toEqual([0, 0, 0, 1, 2, 3]);
  });
});

test('what nothing on screen depends on is not computed', () => {
  const studio = videoStudio().add('sepia-a', 'filter/sepia').wire('video-a.layer -> sepia-a.inputImage').bind('sepia-a.amount', UP);
  expect(program(studio).operations).toEqual([]);
});
