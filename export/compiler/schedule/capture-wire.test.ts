import { describe, expect, test } from '@jest/globals';
import { programFaults } from '../../../tests/compile/program-faults.ts';
import { LIBRARY } from '../../../tests/support/library.ts';
import { readShader } from '../../../tests/support/test-library.ts';
import { TestStudio, wireOf } from '../../../tests/support/test-studio.ts';
import { removeAsset } from '../../graph/commands/asset-commands.ts';
import { connect } from '../../graph/commands/wire-commands.ts';
import { MAIN_GRAPH } from '../../graph/project.ts';
import { mayRest } from '../../program/may-rest.ts';
import type { Program } from '../../program/program.ts';

const asset = (name: string) => ({ path: `assets/${name}.capture/capture.json`, kind: 'capture', credit: name }) as const;

/** Two captures, a phantom of the mesh of the first, and a scene with it on the screen. */
function studio(): TestStudio {
  return new TestStudio({ library: LIBRARY, readShader })
    .asset('hall', asset('hall'))
    .asset('court', asset('court'))
    .asset('other', asset('other'))
    .add('hall-a', 'source/capture', { file: 'hall', positionM: [1, 2, 3], scale: 2 })
    .add('court-a', 'source/capture', { file: 'court' })
    .add('mesh-a', 'source/capture-mesh', { file: 'other', positionM: [9, 9, 9] })
    .add('scene-a', 'layer/scene')
    .add('over-a', 'operator/over')
    .add('screen-a', 'output/screen')
    .wire('hall-a.capture -> mesh-a.capture', 'mesh-a.objects -> scene-a.objects', 'scene-a.layer -> over-a.top');
}

function programOf(made: TestStudio): Program {
  const { output, diagnostics } = made.compile();
  if (!output) throw new Error(JSON.stringify(diagnostics));
  expect(programFaults(output)).toEqual([]);
  return output;
}

const kinds = ({ operations }: Program) =>
  operations.flatMap((operation) => ('type' in operation ? [[operation.id, operation.kind, operation.type]] : []));
const paths = ({ assets }: Program) => assets.map(({ path }) => path).sort();

describe('a capture that is wired to another node', () => {
  test('is written before the mesh that reads it; the mesh uses nothing of its own', () => {
    const made = studio().wire('hall-a.layer -> over-a.bottom', 'over-a.layer -> screen-a.layer');
    const program = programOf(made);
    expect(kinds(program).slice(0, 2)).toEqual([
      ['hall-a.capture', 'source', 'part/capture-place'],
      ['mesh-a', 'source', 'source/capture-mesh'],
    ]);
    expect(program.operations.find(({ id }) => id === 'mesh-a')).toMatchObject({
      reads: ['hall-a.capture'],
      inputs: { capture: [{ kind: 'resource', resource: 'hall-a.capture' }] },
      assets: { file: null },
    });
    expect(program.operations.find(({ id }) => id === 'hall-a.capture')).toMatchObject({ assets: { file: 'hall' }, config: {} });
    // Both operations of the node read the same values.
    const [part, draw] = ['hall-a.capture', 'hall-a'].map((id) => program.operations.find((operation) => operation.id === id));
    expect(part && 'params' in part && draw && 'params' in draw && part.params).toEqual(draw && 'params' in draw && draw.params);
    expect(paths(program)).toEqual(['assets/hall.capture/capture.json']);
    expect(program.credits?.flatMap(({ title, kind }) => (kind === 'asset' ? [title] : []))).toEqual(['assets/hall.capture/capture.json']);
    expect(mayRest(program)).toBe(true);
  });

  test('is not drawn if nothing shows its layer', () => {
    const program = programOf(studio().wire('scene-a.layer -> screen-a.layer'));
    expect(kinds(program).map(([id]) => id)).toEqual(['hall-a.capture', 'mesh-a', 'scene-a']);
    expect(paths(program)).toEqual(['assets/hall.capture/capture.json']);
  });

  test('is followed when its place is bound to an expression, which runs first', () => {
    const made = studio().wire('scene-a.layer -> screen-a.layer').bind('hall-a.positionM', { expression: '[sin(time), 0, 0]' });
    expect(kinds(programOf(made)).map(([, , type]) => type)).toEqual([
      'binding/expression',
      'part/capture-place',
      'source/capture-mesh',
      'layer/scene',
    ]);
    // What is bound to a param that the wire replaces is not computed.
    made.bind('mesh-a.positionM', { expression: '[cos(time), 0, 0]' });
    expect(kinds(programOf(made))).toHaveLength(4);
  });

  test('can be one of two, and the mesh that of the other', () => {
    const made = studio().wire('hall-a.layer -> over-a.bottom', 'over-a.layer -> screen-a.layer');
    made.unwire('hall-a.capture -> mesh-a.capture').wire('court-a.capture -> mesh-a.capture');
    const program = programOf(made);
    expect(program.operations.find(({ id }) => id === 'mesh-a')?.reads).toEqual(['court-a.capture']);
    expect(kinds(program).map(([id]) => id)).toEqual(['court-a.capture', 'mesh-a', 'hall-a', 'scene-a']);
    expect(paths(program)).toEqual(['assets/court.capture/capture.json', 'assets/hall.capture/capture.json']);
  });

  test('that is not wired leaves no trace', () => {
    const made = studio()
      .wire('hall-a.layer -> over-a.bottom', 'over-a.layer -> screen-a.layer')
      .unwire('hall-a.capture -> mesh-a.capture');
    const program = programOf(made);
    expect(program.resources.some(({ kind }) => kind === 'capture')).toBe(false);
    expect(kinds(program).map(([id]) => id)).toEqual(['mesh-a', 'hall-a', 'scene-a']);
    expect(paths(program)).toEqual(['assets/hall.capture/capture.json', 'assets/other.capture/capture.json']);
  });
});

describe('mistakes with the wire of a capture', () => {
  const shown = () => studio().remove('over-a').wire('scene-a.layer -> screen-a.layer');
  const codes = (made: TestStudio) => made.compile().diagnostics.map(({ code, nodeId, port }) => [code, nodeId, port]);

  test('a mesh needs no file of its own, but its capture does', () => {
    const made = shown().set('mesh-a.file', '');
    expect(codes(made)).toEqual([]);
    made.set('hall-a.file', '');
    expect(codes(made)).toEqual([['SCR030', 'hall-a', 'file']]);
    made.unwire('hall-a.capture -> mesh-a.capture');
    expect(codes(made)).toEqual([['SCR030', 'mesh-a', 'file']]);
  });

  test('a capture whose asset is removed is reported, and shows no other', () => {
    const made = shown().run((project) => removeAsset(project, { library: LIBRARY, id: 'hall' }));
    expect(codes(made)).toEqual([['SCR030', 'hall-a', 'file']]);
    expect(paths(programOf(made))).toEqual([]);
  });

  test('the mesh of a muted capture does not fall back to a file of its own', () => {
    const program = programOf(shown().mute('hall-a'));
    expect(program.operations.find(({ id }) => id === 'mesh-a')).toMatchObject({ inputs: { capture: [] }, assets: { file: null } });
    expect(paths(program)).toEqual([]);
  });

  test('wires of other types are refused', () => {
    const made = shown();
    const refusal = (text: string) =>
      made.attempt((project) => connect(project, { library: made.library, graph: MAIN_GRAPH, ...wireOf(text) })).map(({ code }) => code);
    expect(refusal('hall-a.layer -> mesh-a.capture')).toEqual(['SCR013']);
    expect(refusal('hall-a.capture -> scene-a.objects')).toEqual(['SCR013']);
    expect(refusal('court-a.capture -> mesh-a.capture')).toEqual([]);
  });

  test('a place that follows what its own mesh meets is a loop through a delay, which is allowed', () => {
    const made = shown().add('pick-a', 'input/pick').wire('mesh-a.objects -> pick-a.objects', 'pick-a.normal -> hall-a.positionM');
    const order = kinds(programOf(made)).map(([id]) => id);
    expect(order.indexOf('pick-a')).toBeLessThan(order.indexOf('hall-a.capture'));
    expect(order.indexOf('hall-a.capture')).toBeLessThan(order.indexOf('mesh-a'));
  });
});
