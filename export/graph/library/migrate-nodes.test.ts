import { describe, expect, test } from '@jest/globals';
import { defineNode, libraryOf, type NodeDefinition } from '../../../nodes/kit/definition.ts';
import { newProject } from '../new-project.ts';
import type { Binding, Project } from '../project.ts';
import { migrateNodes } from './migrate-nodes.ts';

/** Version 2 renamed `size`; version 3 counts in meters what was in centimeters, in keyframes too. */
const BOX: NodeDefinition = defineNode({
  type: 'objects/box',
  version: 3,
  title: 'Box',
  doc: '',
  inputs: {},
  outputs: {},
  params: { side: { type: 'number', stage: 'uniform', label: 'Side', doc: '', default: 1, unit: 'm' } },
  lowering: { kind: 'geometry' },
  migrations: [
    ({ size, ...rest }) => ({ ...rest, ...(size === undefined ? {} : { side: size }) }),
    ({ side, ...rest }) => ({ ...rest, ...(side === undefined ? {} : { side: inMeters(side) }) }),
  ],
});

function inMeters(saved: unknown): unknown {
  if (typeof saved === 'number') return saved / 100;
  const { track } = saved as { track: { keys: { value: number }[] } };
  return { track: { ...track, keys: track.keys.map((key) => ({ ...key, value: key.value / 100 })) } };
}

function projectWith(version: number, params: Record<string, Binding>): Project {
  const main = { nodes: { 'box-aaaa': { type: 'objects/box', version, params } }, wires: [], exposed: { inputs: [], outputs: [] } };
  return { ...newProject(''), graphs: { main, other: { ...main, nodes: {} } } };
}

const library = libraryOf([BOX], {});
const boxOf = (project: Project) => project.graphs.main?.nodes['box-aaaa'];

describe('migrateNodes', () => {
  test('takes every step from the version that was saved', () => {
    expect(boxOf(migrateNodes(projectWith(1, { size: { value: 50 } }), library).project)).toEqual({
      type: 'objects/box',
      version: 3,
      params: { side: { value: 0.5 } },
    });
    expect(boxOf(migrateNodes(projectWith(2, { side: { value: 50 } }), library).project)?.params).toEqual({ side: { value: 0.5 } });
  });

  test('steps see params as the file has them, bindings included', () => {
    const track = (value: number): Binding => ({ track: { keys: [{ timeS: 0, value, easing: 'linear' }], repeat: 'loop' } });
    expect(boxOf(migrateNodes(projectWith(1, { size: track(50) }), library).project)?.params).toEqual({ side: track(0.5) });
  });

  test('what needs nothing stays the same object', () => {
    const now = projectWith(3, { side: { value: 1 } });
    expect(migrateNodes(now, library).project).toBe(now);
    const old = projectWith(1, {});
    const { project } = migrateNodes(old, library);
    expect(project.graphs.other).toBe(old.graphs.other);
    expect(project.graphs.main?.wires).toBe(old.graphs.main?.wires);
  });

  test('newer versions and unknown types are left alone', () => {
    const newer = projectWith(4, { side: { value: 1 } });
    expect(migrateNodes(newer, library)).toEqual({ project: newer, diagnostics: [] });
    expect(migrateNodes(projectWith(1, {}), libraryOf([], {})).diagnostics).toEqual([]);
  });

  test('params that a step cannot read are kept and told', () => {
    const odd = projectWith(2, { side: { expression: 'x' } });
    const { project, diagnostics } = migrateNodes(odd, library);
    expect(project).toBe(odd);
    expect(diagnostics).toMatchObject([{ code: 'SCR018', severity: 'error', nodeId: 'box-aaaa' }]);
  });
});

/** As a shader file says it (`SCRIM_RENAMED`): version 2 measures in pixels what was in meters, version 3 only renames. */
const LINES: NodeDefinition = defineNode({
  type: 'technique/lines',
  version: 3,
  title: 'Lines',
  doc: '',
  inputs: {},
  outputs: {},
  params: { width: { type: 'number', stage: 'uniform', label: 'Width', doc: '', default: 3, unit: 'px' } },
  lowering: { kind: 'technique', shader: 'techniques/lines.glsl' },
  renamed: [{ widthM: { to: 'widthPx', times: 750 } }, { widthPx: { to: 'width', times: 1 } }],
});

describe('params that a shader file renamed', () => {
  const linesOf = (version: number, params: Record<string, Binding>, port = 'widthM'): Project => {
    const to = { node: 'lines-aaaa', port };
    const nodes = { 'lines-aaaa': { type: 'technique/lines', version, params } };
    const wires = [{ from: { node: 'number-aaaa', port: 'result' }, to }];
    const inputs = [{ name: 'thickness', ...to }];
    return { ...newProject(''), graphs: { main: { nodes, wires, exposed: { inputs, outputs: [] } } } };
  };
  const migrated = (project: Project) => migrateNodes(project, libraryOf([LINES], {}));

  test.each<[string, Binding, Binding]>([
    ['a value', { value: 0.004 }, { value: 3 }],
    ['an expression', { expression: '0.004 + time' }, { expression: '(0.004 + time) * 750' }],
    ['the value of a port that is not connected', { port: 0.008 }, { port: 6 }],
    [
      'a track',
      { track: { keys: [{ timeS: 0, value: 0.002, easing: 'linear' }], repeat: 'loop' } },
      { track: { keys: [{ timeS: 0, value: 1.5, easing: 'linear' }], repeat: 'loop' } },
    ],
  ])('%s goes through all steps', (_what, before, after) => {
    const { project } = migrated(linesOf(1, { widthM: before }));
    expect(project.graphs.main?.nodes['lines-aaaa']).toEqual({ type: 'technique/lines', version: 3, params: { width: after } });
  });

  test('an earlier default stays where a project stores no value, and only there', () => {
    const changed: NodeDefinition = { ...LINES, version: 2, renamed: [{ width: { to: 'width', times: 1, was: 2 } }] };
    const paramsOf = (version: number, params: Record<string, Binding>) =>
      migrateNodes(linesOf(version, params, 'width'), libraryOf([changed], {})).project.graphs.main?.nodes['lines-aaaa']?.params;
    expect(paramsOf(1, {})).toEqual({ width: { value: 2 } });
    expect(paramsOf(1, { width: { value: 5 } })).toEqual({ width: { value: 5 } });
    expect(paramsOf(2, {})).toEqual({});
  });

  test('wires and shown ports follow, and the user is told where what they carry was measured otherwise', () => {
    const { project, diagnostics } = migrated(linesOf(1, {}));
    expect(project.graphs.main?.wires[0]?.to).toEqual({ node: 'lines-aaaa', port: 'width' });
    expect(project.graphs.main?.exposed.inputs).toEqual([{ name: 'thickness', node: 'lines-aaaa', port: 'width' }]);
    expect(diagnostics[0]).toMatchObject({ severity: 'warning', port: 'width', fix: 'Multiply the connected value by 750.' });
    expect(migrated(linesOf(2, {}, 'widthPx'))).toMatchObject({ diagnostics: [] });
  });
});
