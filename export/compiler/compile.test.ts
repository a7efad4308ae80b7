import { describe, expect, test } from '@jest/globals';
import { draws, ids, passes, problems, program } from '../../tests/compile/compiled.ts';
import { emptyStudio, sceneStudio, subgraphs, videoStudio } from '../../tests/compile/graphs.ts';
import { programFaults } from '../../tests/compile/program-faults.ts';
import { TEST_LIBRARY as library } from '../../tests/support/test-library.ts';
import type { TestStudio } from '../../tests/support/test-studio.ts';
import { compile } from './compile.ts';

describe('values', () => {
  test('a wired param reads the slot that the value writes; a toggle is read as the number it is', () => {
    const made = program(subgraphs());
    const [toggle] = made.operations;
    const written = toggle?.kind === 'value' && toggle.outputs.value?.kind === 'slot' ? toggle.outputs.value.slot : -1;
    const read = passes(made)[2]?.uniforms[0]?.source;
    if (!read || !('slot' in read)) throw new Error('No slot is read.');
    expect(made.slots.slots[written]).toEqual({ type: 'toggle', offset: 0 });
    expect(made.slots.slots[read.slot]).toEqual({ type: 'number', offset: 0 });
  });

  test('a param shown by a subgraph can be set by either name', () => {
    const { params } = program(subgraphs()).slots;
    expect(params['twice-a/first-a.strength']).toBe(params['twice-a/first-a/sepia-a.amount']);
  });

  test('a value beyond its limits is used as the nearest within, and told', () => {
    const studio = videoStudio()
      .add('sepia-a', 'filter/sepia', { amount: 0.5 })
      .wire('video-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer');
    // As a file may say, but no command would.
    studio.project = { ...studio.project, graphs: JSON.parse(JSON.stringify(studio.project.graphs).replace('"value":0.5', '"value":7')) };
    const made = program(studio);
    expect(made.slots.numbers[made.slots.slots[made.slots.params['sepia-a.amount'] ?? -1]?.offset ?? -1]).toBe(1);
    expect(problems(studio)).toEqual([{ code: 'SCR018', severity: 'warning', nodeId: 'sepia-a', port: 'amount' }]);
  });
});

describe('loops', () => {
  const looped = () =>
    videoStudio()
      .add('sepia-a', 'filter/sepia')
      .add('sum-a', 'value/math')
      .add('delay-a', 'value/delay')
      .wire(
        'video-a.layer -> sepia-a.inputImage',
        'sepia-a.layer -> screen-a.layer',
        'sum-a.result -> delay-a.value',
        'delay-a.value -> sum-a.a',
        'delay-a.value -> sepia-a.amount',
      );

  test('are broken at delays, which come first and read what is written after them', () => {
    const made = program(looped());
    const values = made.operations.flatMap((operation) => (operation.kind === 'value' ? [operation] : []));
    expect(values.map(({ id }) => id)).toEqual(['delay-a', 'sum-a']);
    const [delay, sum] = values;
    expect(sum?.outputs.result).toEqual({ kind: 'slot', slot: delay?.params.value });
    expect(delay?.outputs.value).toEqual({ kind: 'slot', slot: sum?.params.a });
    expect(programFaults(made)).toEqual([]);
  });

  test('are found behind delays, where only these lead to the screen', () => {
    expect(ids(program(looped().add('time-a', 'value/time').wire('time-a.seconds -> sum-a.b')), 'value')).toEqual([
      'delay-a',
      'time-a',
      'sum-a',
    ]);
  });

  test('stay loops where the delay is muted', () => {
    expect(problems(looped().mute('delay-a'))).toMatchObject([{ code: 'SCR014', severity: 'error' }]);
  });
});

describe('pulses', () => {
  const counted = () =>
    videoStudio()
      .add('every-a', 'pulse/every')
      .add('every-b', 'pulse/every')
      .add('counter-a', 'value/counter')
      .add('sepia-a', 'filter/sepia')
      .wire(
        'every-b.pulse -> counter-a.count',
        'every-a.pulse -> counter-a.count',
        'counter-a.value -> sepia-a.amount',
        'video-a.layer -> sepia-a.inputImage',
        'sepia-a.layer -> screen-a.layer',
      );

  test('are resources of those that make them, read in the order of the wires', () => {
    const made = program(counted());
    const counter = made.operations.find(({ id }) => id === 'counter-a');
    expect(counter).toMatchObject({
      kind: 'value',
      pulses: ['count', 'reset'],
      inputs: { count: [{ resource: 'every-b.pulse' }, { resource: 'every-a.pulse' }], reset: [] },
      reads: ['every-b.pulse', 'every-a.pulse'],
      writes: ['counter-a.wrapped'],
    });
    expect(made.resources.filter(({ kind }) => kind === 'pulses').map(({ id }) => id)).toEqual([
      'every-a.pulse',
      'every-b.pulse',
      'counter-a.wrapped',
    ]);
    expect(programFaults(made)).toEqual([]);
  });
});

describe('muted nodes', () => {
  const filtered = () =>
    videoStudio()
      .add('sepia-a', 'filter/sepia')
      .add('sobel-a', 'filter/sobel-edges')
      .wire('video-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> sobel-a.inputImage', 'sobel-a.layer -> screen-a.layer');

  test('let their first layer through', () => {
    expect(passes(program(filtered().mute('sepia-a')))).toMatchObject([
      { node: 'sobel-a', samplers: [{ source: { resource: 'video-a.layer' } }] },
    ]);
    expect(program(filtered().mute('sepia-a', 'sobel-a')).operations).toEqual([]);
  });

  test('a subgraph too, as a whole', () => {
    const made = program(
      subgraphs()
        .mute('twice-a')
        .add('sepia-z', 'filter/sepia')
        .wire('twice-a.layer -> sepia-z.inputImage', 'sepia-z.layer -> screen-a.layer'),
    );
    expect(passes(made)).toMatchObject([{ node: 'sepia-z', samplers: [{ source: { resource: 'video-a.layer' } }] }]);
  });

  test('and subgraphs can be looked at: what is seen is what stands in for them', () => {
    const studio = subgraphs().add('sepia-z', 'filter/sepia').wire('twice-a.layer -> sepia-z.inputImage').mute('sepia-z');
    const made = program(studio, { taps: ['twice-a.layer', 'twice-a/first-a.layer', 'sepia-z.layer'] });
    expect(Object.entries(made.taps).map(([name, { color }]) => [name, color])).toEqual([
      ['sepia-z.layer', 'twice-a/second-a/sobel-a.layer'],
      ['twice-a.layer', 'twice-a/second-a/sobel-a.layer'],
      ['twice-a/first-a.layer', 'twice-a/first-a/sobel-a.layer'],
    ]);
  });

  test('let objects through, all of them where several go', () => {
    const made = program(
      sceneStudio()
        .wire('video-a.layer -> over-a.bottom')
        .add('box-b', 'objects/primitive')
        .add('group-a', 'objects/group')
        .wire('box-a.objects -> group-a.objects', 'box-b.objects -> group-a.objects', 'group-a.objects -> scene-a.objects')
        .unwire('box-a.objects -> scene-a.objects')
        .mute('group-a'),
    );
    expect(draws(made)[0]?.inputs.objects).toEqual([
      { kind: 'resource', resource: 'box-a.objects' },
      { kind: 'resource', resource: 'box-b.objects' },
    ]);
  });

  test('that let nothing through leave a mistake behind, with their name in it', () => {
    const { output, diagnostics } = compile({
      project: videoStudio()
        .add('sepia-a', 'filter/sepia')
        .wire('video-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer')
        .mute('video-a').project,
      library,
    });
    expect(output).toBeNull();
    expect(diagnostics).toMatchObject([{ code: 'SCR015', nodeId: 'sepia-a', port: 'inputImage' }]);
    expect(diagnostics[0]?.message).toContain('video-a is muted');
  });

  test('a muted screen shows nothing, which is a mistake', () => {
    expect(problems(videoStudio().mute('screen-a'))).toMatchObject([{ code: 'SCR017', severity: 'error' }]);
  });
});

describe('what cannot be compiled', () => {
  test('a node in the making does not stop the picture, half-written expressions included', () => {
    const studio = videoStudio()
      .add('sepia-a', 'filter/sepia')
      .add('sepia-b', 'filter/sepia')
      .add('sepia-c', 'filter/sepia')
      .wire('sepia-a.layer -> sepia-b.inputImage', 'video-a.layer -> sepia-c.inputImage')
      .bind('sepia-b.amount', { expression: 'time' })
      .bind('sepia-c.amount', { expression: 'sin(' });
    const made = program(studio, { taps: ['sepia-b.layer', 'sepia-a.layer', 'sepia-c.layer'] });
    expect(made.operations).toEqual([]);
    expect(made.taps).toEqual({});
    expect(problems(studio)).toEqual([
      { code: 'SCR015', severity: 'warning', nodeId: 'sepia-a', port: 'inputImage' },
      { code: 'SCR022', severity: 'warning', nodeId: 'sepia-c', port: 'amount' },
    ]);
  });

  test('nodes that nothing depends on are told when asked for', () => {
    const studio = videoStudio().add('room-a', 'world/depth');
    expect(problems(studio)).toEqual([]);
    expect(problems(studio, { reportUnused: true })).toEqual([{ code: 'SCR021', severity: 'info', nodeId: 'room-a', port: undefined }]);
  });

  test('a broken shader is told at its line, for every node that uses it', () => {
    const broken =
      '/*{"ISFVSN":"2","INPUTS":[{"NAME":"inputImage","TYPE":"image"}]}*/\nvoid main() {\n  gl_FragColor = IMG_THIS_PIXEL(inputImage\n}\n';
    const studio = videoStudio()
      .source('edge.fs', broken)
      .add('edge-a', 'filter/edge')
      .add('edge-b', 'filter/edge')
      .wire('video-a.layer -> edge-a.inputImage', 'edge-a.layer -> edge-b.inputImage', 'edge-b.layer -> screen-a.layer');
    const { output, diagnostics } = compile({ project: studio.project, library });
    expect(output).toBeNull();
    expect(diagnostics).toMatchObject([
      { code: 'SCR041', severity: 'error', nodeId: 'edge-a', file: 'shaders/edge.fs' },
      { code: 'SCR041', severity: 'error', nodeId: 'edge-b', file: 'shaders/edge.fs' },
    ]);
    expect(diagnostics[0]?.line).toBeGreaterThan(2);
  });

  test('a broken shader that is only looked at takes no more than its own picture', () => {
    const studio = videoStudio()
      .source('edge.fs', '/*{"ISFVSN":"2","INPUTS":[{"NAME":"inputImage","TYPE":"image"}]}*/\nvoid main() { gl_FragColor = ; }\n')
      .add('edge-a', 'filter/edge')
      .add('sepia-a', 'filter/sepia')
      .wire('video-a.layer -> edge-a.inputImage', 'video-a.layer -> sepia-a.inputImage');
    const made = program(studio, { taps: ['edge-a.layer', 'sepia-a.layer'] });
    expect(Object.keys(made.taps)).toEqual(['sepia-a.layer']);
  });

  test('a broken header is an error where a node uses it, and else work in progress', () => {
    const studio = videoStudio()
      .source('edge.fs', '/*{"INPUTS":[{"NAME":"inputImage","TYPE":"image"}]}*/void main() { gl_FragColor = vec4(1.0); }')
      .add('edge-a', 'filter/edge');
    const wired = (made: TestStudio) => made.wire('video-a.layer -> edge-a.inputImage', 'edge-a.layer -> screen-a.layer');
    const unused = videoStudio().source('edge.fs', 'no header at all');
    expect(problems(unused)).toMatchObject([{ code: 'SCR040', severity: 'warning' }]);
    expect(problems(wired(studio).source('edge.fs', 'no header at all')).map(({ code, severity }) => [code, severity])).toEqual([
      ['SCR040', 'error'],
      ['SCR010', 'error'],
    ]);
  });

  test('subgraphs that would multiply without end are refused', () => {
    const bomb = emptyStudio();
    for (let level = 0; level < 30; level++) {
      bomb.in(`g${level}`);
      const type = level === 0 ? 'filter/sepia' : `graph/g${level - 1}`;
      bomb.add('a-a', type).add('b-a', type);
    }
    bomb
      .in('main')
      .add('bomb-a', 'graph/g29')
      .add('video-a', 'source/camera-video')
      .add('screen-a', 'output/screen')
      .wire('video-a.layer -> screen-a.layer');
    expect(problems(bomb)).toMatchObject([{ code: 'SCR026', severity: 'error' }]);
  });
});
