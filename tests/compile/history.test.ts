import { describe, expect, test } from '@jest/globals';
import { isHistoryDependent } from '../../export/program/history-dependence.ts';
import { compileText } from '../support/compile-project.ts';
import { type ProjectText, projectText } from '../support/project-kit.ts';

const IMAGE: ProjectText['nodes'] = { 'video-a1b2': 'source/camera-video', 'sepia-a1b2': 'filter/sepia', 'screen-a1b2': 'output/screen' };
const WIRES = ['video-a1b2.layer -> sepia-a1b2.inputImage', 'sepia-a1b2.layer -> screen-a1b2.layer'];

/** Sepia, its amount moved by what `nodes` and `wires` say. */
function sepia(nodes: ProjectText['nodes'], ...wires: string[]): boolean {
  return isHistoryDependent(compileText(projectText({ nodes: { ...IMAGE, ...nodes }, wires: [...WIRES, ...wires] })));
}

function depth(params: Record<string, unknown>, nodes: ProjectText['nodes'] = {}, ...wires: string[]): boolean {
  return isHistoryDependent(
    compileText(
      projectText({
        nodes: {
          'box-a1b2': 'objects/primitive',
          'scene-a1b2': 'layer/scene',
          'room-a1b2': ['world/depth', params],
          'hide-a1b2': 'layer/depth-occlusion',
          'screen-a1b2': 'output/screen',
          ...nodes,
        },
        wires: [
          'box-a1b2.objects -> scene-a1b2.objects',
          'scene-a1b2.layer -> hide-a1b2.layer',
          'room-a1b2.depth -> hide-a1b2.depth',
          'hide-a1b2.layer -> screen-a1b2.layer',
          ...wires,
        ],
      } as ProjectText),
    ),
  );
}

/** Which nodes are stateful, `tests/unit/stateful-nodes.test.ts` proves by playing them. */
describe('a program depends on its history', () => {
  test('where a stateful node moves what is seen, and not where it moves nothing', () => {
    const beat = { 'every-a1b2': 'pulse/every', 'count-a1b2': 'value/counter', 'math-a1b2': 'value/math' } as const;
    const counted = ['every-a1b2.pulse -> count-a1b2.up', 'count-a1b2.number -> math-a1b2.a'];
    expect(sepia({})).toBe(false);
    expect(sepia(beat, ...counted, 'math-a1b2.result -> sepia-a1b2.amount')).toBe(true);
    expect(sepia(beat, ...counted)).toBe(false);
  });

  test('where the speed of time moves, and not where it is steady', () => {
    const time = { 'time-a1b2': ['value/time', { speed: 2 }], 'wave-a1b2': 'value/math' } as const;
    const steady = ['time-a1b2.seconds -> sepia-a1b2.amount'];
    expect(sepia(time as never, ...steady)).toBe(false);
    expect(sepia({ ...time, 'slow-a1b2': 'value/expression' } as never, ...steady, 'slow-a1b2.result -> time-a1b2.speed')).toBe(true);
  });

  test('where room depth is smoothed, or may be', () => {
    expect(depth({})).toBe(false);
    expect(depth({ smoothingS: 0.2 })).toBe(true);
    expect(depth({}, { 'slow-a1b2': 'input/slider' }, 'slow-a1b2.number -> room-a1b2.smoothingS')).toBe(true);
  });

  test('where a picture is kept, and where two CPU filters are late one after the other', () => {
    const cpu = 'filter/cpu-equalize-histogram';
    const program = (nodes: ProjectText['nodes'], ...wires: string[]) =>
      isHistoryDependent(
        compileText(projectText({ nodes: { 'video-a1b2': 'source/camera-video', 'screen-a1b2': 'output/screen', ...nodes }, wires })),
      );
    const one = ['video-a1b2.layer -> one-a1b2.inputImage'];
    expect(program({ 'one-a1b2': cpu }, ...one, 'one-a1b2.layer -> screen-a1b2.layer')).toBe(false);
    const two = [...one, 'one-a1b2.layer -> two-a1b2.inputImage', 'two-a1b2.layer -> screen-a1b2.layer'];
    expect(program({ 'one-a1b2': cpu, 'two-a1b2': cpu }, ...two)).toBe(true);
    const kept = ['video-a1b2.layer -> kept-a1b2.layer', 'kept-a1b2.layer -> screen-a1b2.layer'];
    expect(program({ 'kept-a1b2': 'layer/previous-frame' }, ...kept)).toBe(true);
  });
});
