import { describe, expect, test } from '@jest/globals';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { readShader, TEST_LIBRARY } from '../../../tests/support/test-library.ts';
import { TestStudio, wireOf } from '../../../tests/support/test-studio.ts';
import { isNodeId, makeNodeId } from '../document-names.ts';
import { printWire, sortWires } from '../wires.ts';
import { removeAsset } from './asset-commands.ts';
import { changeType } from './change-type.ts';
import { putFrame, putNote, removeFromLayout, setCollapsed } from './layout-commands.ts';
import { addNode } from './node-commands.ts';
import { setParam } from './param-commands.ts';
import { setPage, setTitle } from './project-info.ts';
import { exposePort, hidePort, removeGraph, renameExposed, renameGraph } from './subgraph-commands.ts';
import { connect, reorderWires } from './wire-commands.ts';

const library: NodeLibrary = TEST_LIBRARY;

function studio(): TestStudio {
  return new TestStudio({ library, readShader });
}

/** video → sepia → screen. */
function sepiaStudio(): TestStudio {
  return studio()
    .add('video-aaaa', 'source/camera-video')
    .add('sepia-aaaa', 'filter/sepia')
    .add('screen-aaaa', 'output/screen')
    .wire('video-aaaa.layer -> sepia-aaaa.inputImage', 'sepia-aaaa.layer -> screen-aaaa.layer');
}

function wires(made: TestStudio, graph = 'main'): string[] {
  return (made.project.graphs[graph]?.wires ?? []).map(printWire);
}

function paramsOf(made: TestStudio, node: string, graph = 'main') {
  return made.project.graphs[graph]?.nodes[node]?.params;
}

describe('nodes', () => {
  test('ids are a readable stem and a suffix, new in the whole project', () => {
    const made = studio().add('gaussian-blur-aaaa', 'filter/gaussian-blur');
    expect(makeNodeId(made.project, 'filter/gaussian-blur', () => 0)).toBe('gaussian-blur-baaa');
    expect(makeNodeId(made.project, 'filter/CMYK Halftone (v2)', () => 0.5)).toMatch(/^cmyk-halftone-v2-[a-z0-9]{4}$/);
    for (const type of ['filter/3d Rotate', 'filter/Größe', 'filter/日本', 'graph/look'])
      expect(isNodeId(makeNodeId(made.project, type, () => 0.9999))).toBe(true);
  });

  test('a node comes with the version of its type and its own values', () => {
    const made = studio().add('box-aaaa', 'objects/primitive', { shape: 'sphere', color: [1, 1, 1, 1] });
    expect(made.project.graphs.main?.nodes['box-aaaa']).toEqual({
      type: 'objects/primitive',
      version: 1,
      params: { shape: { value: 'sphere' } },
    });
    expect(made.project.layout.main?.nodes['box-aaaa']).toEqual({ x: 0, y: 0 });
  });

  test('a node with a value that does not fit is not added at all', () => {
    const made = studio();
    const before = made.project;
    expect(
      made.attempt((p) =>
        addNode(p, { library, graph: 'main', id: 'box-aaaa', type: 'objects/primitive', x: 0, y: 0, params: { shape: 'cone' } }),
      ),
    ).toMatchObject([{ code: 'SCR018' }]);
    expect(made.project).toBe(before);
  });

  test('an unknown type is refused', () => {
    expect(studio().attempt((p) => addNode(p, { library, graph: 'main', id: 'x-aaaa', type: 'filter/none', x: 0, y: 0 }))).toMatchObject([
      { code: 'SCR010' },
    ]);
  });

  test('a removed node takes its wires and its place with it', () => {
    const made = sepiaStudio().remove('sepia-aaaa');
    expect(wires(made)).toEqual([]);
    expect(Object.keys(made.project.layout.main?.nodes ?? {})).toEqual(['video-aaaa', 'screen-aaaa']);
  });

  test('muting is stored only where it is so', () => {
    const made = sepiaStudio().mute('sepia-aaaa');
    expect(made.project.graphs.main?.nodes['sepia-aaaa']?.muted).toBe(true);
  });
});

describe('wires', () => {
  test('a second wire replaces the first where only one fits', () => {
    const made = sepiaStudio().wire('video-aaaa.layer -> screen-aaaa.layer');
    expect(wires(made)).toEqual(['video-aaaa.layer -> screen-aaaa.layer', 'video-aaaa.layer -> sepia-aaaa.inputImage']);
  });

  test('where several fit they count in the order they were drawn, until they are reordered', () => {
    const made = studio().add('z-aaaa', 'objects/primitive').add('a-aaaa', 'objects/primitive').add('group-aaaa', 'objects/group');
    made.wire('z-aaaa.objects -> group-aaaa.objects', 'a-aaaa.objects -> group-aaaa.objects');
    expect(wires(made)).toEqual(['z-aaaa.objects -> group-aaaa.objects', 'a-aaaa.objects -> group-aaaa.objects']);
    made.reopen();
    expect(wires(made)[0]).toBe('z-aaaa.objects -> group-aaaa.objects');
    const to = { node: 'group-aaaa', port: 'objects' };
    made.run((p) =>
      reorderWires(p, {
        graph: 'main',
        to,
        from: [
          { node: 'a-aaaa', port: 'objects' },
          { node: 'z-aaaa', port: 'objects' },
        ],
      }),
    );
    expect(wires(made)).toEqual(['a-aaaa.objects -> group-aaaa.objects', 'z-aaaa.objects -> group-aaaa.objects']);
  });

  test('stay in the order of the document', () => {
    const made = sepiaStudio();
    expect(made.project.graphs.main?.wires).toEqual(sortWires(made.project.graphs.main?.wires ?? []));
  });

  test('a wired param becomes a port that keeps its value', () => {
    const made = sepiaStudio()
      .set('sepia-aaaa.amount', 0.25)
      .add('number-aaaa', 'value/number')
      .wire('number-aaaa.value -> sepia-aaaa.amount');
    expect(paramsOf(made, 'sepia-aaaa')).toEqual({ amount: { port: 0.25 } });
    made.unwire('number-aaaa.value -> sepia-aaaa.amount');
    expect(paramsOf(made, 'sepia-aaaa')).toEqual({ amount: { port: 0.25 } });
    expect(wires(made)).toHaveLength(2);
  });
});

describe('params', () => {
  test('a value equal to the default is not stored', () => {
    const made = sepiaStudio().set('sepia-aaaa.amount', 0.5);
    expect(paramsOf(made, 'sepia-aaaa')).toEqual({ amount: { value: 0.5 } });
    expect(paramsOf(made.set('sepia-aaaa.amount', 1), 'sepia-aaaa')).toEqual({});
  });

  test.each<[string, string, number | string | readonly number[]]>([
    ['NaN', 'sepia-aaaa.amount', Number.NaN],
    ['infinity', 'sepia-aaaa.amount', Number.POSITIVE_INFINITY],
    ['a text for a number', 'sepia-aaaa.amount', '1'],
    ['too much', 'sepia-aaaa.amount', 1.01],
    ['an unknown param', 'sepia-aaaa.amnt', 1],
    ['a vector of three for a color', 'color-aaaa.color', [1, 1, 1]],
    ['a vector with a hole', 'color-aaaa.color', [1, Number.NaN, 1, 1]],
    ['an unknown choice', 'box-aaaa.shape', 'cone'],
  ])('%s is refused and changes nothing', (_, address, value) => {
    const made = sepiaStudio().add('color-aaaa', 'value/color').add('box-aaaa', 'objects/primitive');
    const before = made.project;
    const [node = '', param = ''] = address.split('.');
    const [diagnostic] = made.attempt((p) => setParam(p, { library, graph: 'main', node, param, value }));
    expect(diagnostic).toMatchObject({ code: 'SCR018', severity: 'error', nodeId: node, port: param });
    expect(made.project).toBe(before);
  });

  test('what a param is bound to instead takes its wire away', () => {
    const made = sepiaStudio()
      .add('number-aaaa', 'value/number')
      .wire('number-aaaa.value -> sepia-aaaa.amount')
      .bind('sepia-aaaa.amount', { expression: 'sin(time)' });
    expect(wires(made)).toHaveLength(2);
    expect(paramsOf(made, 'sepia-aaaa')).toEqual({ amount: { expression: 'sin(time)' } });
    expect(made.attempt((p) => setParam(p, { library, graph: 'main', node: 'sepia-aaaa', param: 'amount', value: 1 }))).toMatchObject([
      { code: 'SCR019' },
    ]);
  });

  test('an asset has to be there and of the right kind; without it the param names none', () => {
    const made = studio()
      .add('model-aaaa', 'source/model')
      .asset('fox-aaaa', { path: 'assets/fox.glb', kind: 'model' })
      .asset('sky-aaaa', { path: 'assets/sky.png', kind: 'image' });
    const set = (value: string) => made.attempt((p) => setParam(p, { library, graph: 'main', node: 'model-aaaa', param: 'model', value }));
    expect(set('wolf-aaaa')).toMatchObject([{ code: 'SCR030' }]);
    expect(set('sky-aaaa')).toMatchObject([{ code: 'SCR033' }]);
    expect(set('fox-aaaa')).toEqual([]);
    made.run((p) => removeAsset(p, { library, id: 'fox-aaaa' }));
    expect(paramsOf(made, 'model-aaaa')).toEqual({});
    expect(made.undo().project.assets['fox-aaaa']?.path).toBe('assets/fox.glb');
    expect(paramsOf(made, 'model-aaaa')).toEqual({ model: { value: 'fox-aaaa' } });
  });
});

describe('layout', () => {
  test('never touches the logic', () => {
    const made = sepiaStudio();
    const { project } = made.save();
    made
      .move('sepia-aaaa', 120.4, -3.6)
      .run((p) => setCollapsed(p, { graph: 'main', nodes: ['sepia-aaaa'], collapsed: true }))
      .run((p) => putFrame(p, { graph: 'main', id: 'frame-aaaa', frame: { x: 0, y: 0, width: 10.2, height: 10, title: 'F' } }))
      .run((p) => putNote(p, { graph: 'main', id: 'note-aaaa', note: { x: 0, y: 0, width: 10, height: 10, text: 'N' } }));
    expect(made.save().project).toBe(project);
    expect(made.project.layout.main).toEqual({
      nodes: { ...made.project.layout.main?.nodes, 'sepia-aaaa': { x: 120, y: -4, collapsed: true } },
      frames: { 'frame-aaaa': { x: 0, y: 0, width: 10, height: 10, title: 'F' } },
      notes: { 'note-aaaa': { x: 0, y: 0, width: 10, height: 10, text: 'N' } },
      reroutes: {},
      routes: {},
    });
    made.run((p) => removeFromLayout(p, { graph: 'main', frames: ['frame-aaaa'], notes: ['note-aaaa'] }));
    expect(made.project.layout.main).toMatchObject({ frames: {}, notes: {} });
  });
});

describe('the project itself', () => {
  test('title and page', () => {
    const made = studio()
      .run((p) => setTitle(p, { title: 'Fox' }))
      .run((p) => setPage(p, { page: { language: 'de' } }));
    expect(made.project).toMatchObject({ title: 'Fox', page: { description: '', language: 'de' } });
    expect(made.save().project).toContain('"language": "de"');
  });
});

describe('subgraphs', () => {
  /** main: video → look → screen; look: sepia, showing its input, its output and its amount. */
  function lookStudio(): TestStudio {
    return studio()
      .in('look')
      .add('sepia-aaaa', 'filter/sepia', { amount: 0.25 })
      .expose('inputs', 'picture', 'sepia-aaaa.inputImage')
      .expose('inputs', 'strength', 'sepia-aaaa.amount')
      .expose('outputs', 'layer', 'sepia-aaaa.layer')
      .in('main')
      .add('video-aaaa', 'source/camera-video')
      .add('look-aaaa', 'graph/look')
      .add('screen-aaaa', 'output/screen')
      .wire('video-aaaa.layer -> look-aaaa.picture', 'look-aaaa.layer -> screen-aaaa.layer');
  }

  test('is a node with the ports it shows, of which params begin with what they are inside', () => {
    const made = lookStudio();
    expect(made.diagnostics()).toEqual([]);
    expect(paramsOf(made.set('look-aaaa.strength', 0.25), 'look-aaaa')).toEqual({});
    expect(paramsOf(made.set('look-aaaa.strength', 0.5), 'look-aaaa')).toEqual({ strength: { value: 0.5 } });
  });

  test('a port no longer shown loses its wires outside, and gets them back by undo', () => {
    const made = lookStudio();
    const before = made.save();
    made.run((p) => hidePort(p, { library, graph: 'look', side: 'outputs', name: 'layer' }));
    expect(wires(made)).toEqual(['video-aaaa.layer -> look-aaaa.picture']);
    expect(made.undo().save()).toEqual(before);
  });

  test('deleting the node behind shown ports settles every graph around it', () => {
    const made = lookStudio()
      .in('outer')
      .add('look-bbbb', 'graph/look')
      .expose('inputs', 'deep', 'look-bbbb.picture')
      .in('main')
      .add('outer-aaaa', 'graph/outer')
      .wire('video-aaaa.layer -> outer-aaaa.deep');
    const before = made.save();
    made.in('look').remove('sepia-aaaa');
    expect(wires(made)).toEqual([]);
    expect(made.project.graphs.outer?.exposed.inputs).toEqual([]);
    expect(made.undo().save()).toEqual(before);
  });

  test('a port for one wire is connected inside or exposed, not both', () => {
    const made = lookStudio()
      .in('look')
      .add('noise-a', 'generator/noise')
      .add('sepia-b', 'filter/sepia')
      .wire('noise-a.layer -> sepia-b.inputImage');
    const outside = made.attempt((p) => connect(p, { library, graph: 'look', ...wireOf('noise-a.layer -> sepia-aaaa.inputImage') }));
    expect(outside).toMatchObject([{ code: 'SCR016', nodeId: 'sepia-aaaa' }]);
    const inside = made.attempt((p) =>
      exposePort(p, { library, graph: 'look', side: 'inputs', name: 'second', node: 'sepia-b', port: 'inputImage' }),
    );
    expect(inside).toMatchObject([{ code: 'SCR016', nodeId: 'sepia-b' }]);
  });

  test('cannot come to contain itself', () => {
    const made = lookStudio().in('outer').add('look-bbbb', 'graph/look');
    const add = (graph: string, type: string) => made.attempt((p) => addNode(p, { library, graph, id: 'x-aaaa', type, x: 0, y: 0 }));
    expect(add('look', 'graph/look')).toMatchObject([{ code: 'SCR020' }]);
    expect(add('look', 'graph/outer')).toMatchObject([{ code: 'SCR020' }]);
    expect(add('look', 'graph/main')).toMatchObject([{ code: 'SCR020' }]);
  });

  test('renaming takes the nodes that use it along', () => {
    const made = lookStudio().move('look-aaaa', 5, 5);
    const before = made.save();
    made.run((p) => renameGraph(p, { from: 'look', to: 'style' }));
    expect(made.project.graphs.main?.nodes['look-aaaa']?.type).toBe('graph/style');
    expect(made.diagnostics()).toEqual([]);
    expect(made.undo().save()).toEqual(before);
    for (const to of ['main', 'Look', '__proto__'])
      expect(made.attempt((p) => renameGraph(p, { from: 'look', to }))).toMatchObject([{ code: 'SCR020' }]);
  });

  test('a renamed port keeps its wires and values outside, in graphs around it, too', () => {
    const made = lookStudio()
      .set('look-aaaa.strength', 0.5)
      .in('outer')
      .add('look-bbbb', 'graph/look')
      .expose('inputs', 'deep', 'look-bbbb.picture')
      .in('main');
    const before = made.save();
    made.run((p) => renameExposed(p, { graph: 'look', side: 'inputs', from: 'picture', to: 'photo' }));
    made.run((p) => renameExposed(p, { graph: 'look', side: 'outputs', from: 'layer', to: 'result' }));
    expect(wires(made)).toEqual(['video-aaaa.layer -> look-aaaa.photo', 'look-aaaa.result -> screen-aaaa.layer']);
    expect(made.project.graphs.outer?.exposed.inputs).toEqual([{ name: 'deep', node: 'look-bbbb', port: 'photo' }]);
    made.run((p) => renameExposed(p, { graph: 'look', side: 'inputs', from: 'strength', to: 'amount' }));
    expect(made.project.graphs.main?.nodes['look-aaaa']?.params).toEqual({ amount: { value: 0.5 } });
    expect(made.diagnostics()).toEqual([]);
    for (const to of ['result', 'Not a name', ''])
      expect(made.attempt((p) => renameExposed(p, { graph: 'look', side: 'inputs', from: 'photo', to }))).toMatchObject([
        { code: 'SCR012' },
      ]);
    expect(made.undo().undo().undo().save()).toEqual(before);
  });

  test('is not removed while it is used', () => {
    const made = lookStudio();
    expect(made.attempt((p) => removeGraph(p, { name: 'look' }))).toMatchObject([{ code: 'SCR020', nodeId: 'look-aaaa' }]);
    expect(Object.keys(made.remove('look-aaaa').run((p) => removeGraph(p, { name: 'look' })).project.graphs)).toEqual(['main']);
  });
});

describe('changing the type of a node', () => {
  test('keeps wires and params of the same name', () => {
    const made = sepiaStudio().set('sepia-aaaa.amount', 0.5);
    made.run((p) => changeType(p, { library, graph: 'main', node: 'sepia-aaaa', type: 'filter/sobel-edges' }));
    expect(wires(made)).toEqual(['sepia-aaaa.layer -> screen-aaaa.layer', 'video-aaaa.layer -> sepia-aaaa.inputImage']);
    expect(paramsOf(made, 'sepia-aaaa')).toEqual({});
    expect(made.diagnostics()).toEqual([]);
  });

  test('moves wires to a port of the same type where the name is gone', () => {
    const made = sepiaStudio();
    made.run((p) => changeType(p, { library, graph: 'main', node: 'sepia-aaaa', type: 'operator/over' }));
    expect(wires(made)).toContain('video-aaaa.layer -> sepia-aaaa.top');
    made.run((p) => changeType(p, { library, graph: 'main', node: 'sepia-aaaa', type: 'objects/group' }));
    expect(wires(made)).toEqual([]);
    expect(made.undo().undo().project).toEqual(sepiaStudio().project);
  });

  test('keeps the first of several wires where only one fits', () => {
    const made = studio().add('z-aaaa', 'objects/primitive').add('a-aaaa', 'objects/primitive').add('group-aaaa', 'objects/group');
    made.wire('z-aaaa.objects -> group-aaaa.objects', 'a-aaaa.objects -> group-aaaa.objects');
    made.run((p) => changeType(p, { library, graph: 'main', node: 'group-aaaa', type: 'objects/transform' }));
    expect(wires(made)).toEqual(['z-aaaa.objects -> group-aaaa.objects']);
  });

  test('a param that is wired stays wired where it can', () => {
    const made = sepiaStudio().add('number-aaaa', 'value/number').wire('number-aaaa.value -> sepia-aaaa.amount');
    made.run((p) => changeType(p, { library, graph: 'main', node: 'sepia-aaaa', type: 'filter/gaussian-blur' }));
    expect(wires(made)).toContain('number-aaaa.value -> sepia-aaaa.radius');
    expect(made.project.graphs.main?.wires).toContainEqual(wireOf('video-aaaa.layer -> sepia-aaaa.inputImage'));
  });
});
