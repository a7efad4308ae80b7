import { describe, expect, test } from '@jest/globals';
import { formatDiagnostic } from '../../nodes/kit/diagnostics.ts';
import { arScene, blurAfterMerging, emptyStudio, fog, imageOnly, subgraphs } from '../../tests/compile/graphs.ts';
import { TEST_LIBRARY as library } from '../../tests/support/test-library.ts';
import type { TestStudio } from '../../tests/support/test-studio.ts';
import type { DrawOperation, PassOperation, Program } from '../program/program.ts';
import { type CompileOptions, compile } from './compile.ts';

function program(studio: TestStudio, options: CompileOptions = {}): Program {
  const { output, diagnostics } = compile({ project: studio.project, library, options });
  if (output === null) throw new Error(diagnostics.map(formatDiagnostic).join('\n'));
  return output;
}

function problems(studio: TestStudio, options: CompileOptions = {}) {
  return compile({ project: studio.project, library, options }).diagnostics.map(({ code, severity, nodeId, port }) => ({
    code,
    severity,
    nodeId,
    port,
  }));
}

const ids = (made: Program, kind?: string) => made.operations.filter((op) => kind === undefined || op.kind === kind).map(({ id }) => id);
const draws = (made: Program) => made.operations.filter((op): op is DrawOperation => op.kind === 'draw');
const passes = (made: Program) => made.operations.filter((op): op is PassOperation => op.kind === 'pass');
const targets = (made: Program) => made.resources.filter(({ kind }) => kind === 'target').map(({ id }) => id);
const asked = (made: Program) => made.needs.map(({ capability }) => capability);

/** video → screen. */
const videoStudio = () =>
  emptyStudio().add('video-a', 'source/camera-video').add('screen-a', 'output/screen').wire('video-a.layer -> screen-a.layer');

/** A scene, an over and a screen, to be wired. */
const sceneStudio = () =>
  emptyStudio()
    .add('video-a', 'source/camera-video')
    .add('box-a', 'objects/primitive')
    .add('scene-a', 'layer/scene')
    .add('over-a', 'operator/over')
    .add('screen-a', 'output/screen')
    .wire('box-a.objects -> scene-a.objects', 'scene-a.layer -> over-a.top', 'over-a.layer -> screen-a.layer');

describe('least privilege', () => {
  test('a video that is only the background asks for nothing and does nothing', () => {
    const made = program(videoStudio());
    expect(made.needs).toEqual([]);
    expect(made.operations).toEqual([]);
    expect(made.presentation).toMatchObject({ background: 'world', mode: 'forward' });
  });

  test('a video that a filter reads asks for the camera', () => {
    const made = program(
      videoStudio().add('sepia-a', 'filter/sepia').wire('video-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer'),
    );
    expect(made.needs).toMatchObject([{ capability: 'camera-image', required: false, nodes: ['video-a'] }]);
    expect(made.tiers.map(({ id }) => id)).toEqual(['ar-camera', 'ar', 'camera', 'authored-vr', 'orbit']);
    expect(made.tiers[1]?.without).toEqual([{ capability: 'camera-image', effect: 'Only virtual things are styled.' }]);
  });

  test('a video above something else is a picture, and asks for the camera', () => {
    const made = program(
      sceneStudio().unwire('scene-a.layer -> over-a.top').wire('video-a.layer -> over-a.top', 'scene-a.layer -> over-a.bottom'),
    );
    expect(asked(made)).toEqual(['camera-image']);
    expect(passes(made).map(({ target, blend }) => [target, blend])).toEqual([['screen', 'over']]);
  });

  test('what nothing on screen depends on asks for nothing', () => {
    expect(program(videoStudio().add('room-a', 'world/depth')).needs).toEqual([]);
  });

  test('what is only looked at asks for nothing either', () => {
    const made = program(videoStudio(), { taps: ['video-a.layer'] });
    expect(made.needs).toEqual([]);
    expect(made.taps).toEqual({ 'video-a.layer': { color: 'video-a.layer', depth: null } });
  });

  test('a required need leaves out the tiers that lack it', () => {
    const strict = {
      ...library,
      definition: (type: string) => {
        const definition = library.definition(type);
        return definition && type === 'world/depth'
          ? { ...definition, needs: definition.needs?.map((need) => ({ ...need, required: true })) ?? [] }
          : definition;
      },
    };
    const { output } = compile({ project: arScene().project, library: strict });
    expect(output?.needs).toMatchObject([{ capability: 'depth', required: true }]);
    expect(output?.tiers).toEqual([{ id: 'ar', without: [] }]);
  });
});

describe('the forward path', () => {
  test('draws a stack of scenes straight onto the screen, in painter’s order, and keeps no picture', () => {
    const made = program(arScene());
    expect(made.presentation).toEqual({ mode: 'forward', antialias: true, background: 'world', blend: 'alpha' });
    expect(draws(made).map(({ id, target }) => [id, target])).toEqual([
      ['shadow-a', 'screen'],
      ['scene-a', 'screen'],
    ]);
    expect(targets(made)).toEqual([]);
    expect(made.shaders).toEqual([]);
  });

  test('an occlusion sinks into the draw it hides a part of', () => {
    expect(draws(program(arScene()))[1]?.occlusion).toMatchObject({ node: 'hide-a', roomDepth: 'room-a.depth' });
  });

  test('equal casters and lights share their shadow maps', () => {
    const made = program(arScene());
    expect(ids(made, 'shadow-maps')).toHaveLength(1);
    expect(new Set(draws(made).map(({ shadowMaps }) => shadowMaps)).size).toBe(1);
    const apart = program(
      arScene().add('sun-b', 'light/directional').unwire('sun-a.lights -> shadow-a.lights').wire('sun-b.lights -> shadow-a.lights'),
    );
    expect(ids(apart, 'shadow-maps')).toHaveLength(2);
  });

  test('a scene with its shadows off has none', () => {
    const made = program(arScene().set('scene-a.shadows', false));
    expect(draws(made).find(({ id }) => id === 'scene-a')?.shadowMaps).toBeNull();
  });

  test('a filter on one layer makes a picture of that layer alone', () => {
    const made = program(
      arScene().add('sepia-a', 'filter/sepia').wire('hide-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> over-b.top'),
    );
    expect(targets(made)).toEqual(['hide-a.layer']);
    expect(draws(made).map(({ id, target }) => [id, target])).toEqual([
      ['scene-a', 'hide-a.layer'],
      ['shadow-a', 'screen'],
    ]);
    expect(passes(made)).toMatchObject([{ id: 'sepia-a.pass0', target: 'screen', blend: 'over' }]);
    expect(ids(made).slice(-2)).toEqual(['shadow-a', 'sepia-a.pass0']);
    expect(made.presentation).toMatchObject({ mode: 'composed', antialias: true });
    expect(asked(made)).toEqual(['depth']);
  });

  test('an `over` that does more than blend is a pass; its opacity can then be set, and else not', () => {
    const plain = sceneStudio().wire('video-a.layer -> over-a.bottom');
    expect(Object.keys(program(plain).slots.params)).not.toContain('over-a.opacity');
    const faded = program(plain.set('over-a.opacity', 0.5));
    expect(passes(faded)).toMatchObject([{ id: 'over-a.pass0', target: 'screen' }]);
    expect(Object.keys(faded.slots.params)).toContain('over-a.opacity');
    const wired = program(plain.add('time-a', 'value/time').wire('time-a.seconds -> over-a.opacity'));
    expect(passes(wired)).toHaveLength(1);
  });

  test('a layer that is needed as a picture elsewhere is drawn once and copied', () => {
    const made = program(
      sceneStudio().add('sepia-a', 'filter/sepia').wire('scene-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> over-a.bottom'),
    );
    expect(draws(made).map(({ target }) => target)).toEqual(['scene-a.layer']);
    expect(passes(made).map(({ id, target }) => [id, target])).toEqual([
      ['sepia-a.pass0', 'screen'],
      ['scene-a.layer.screen1', 'screen'],
    ]);
  });

  test('a picture file at the bottom is laid on by the fit of its over', () => {
    const made = program(sceneStudio().add('sky-a', 'source/image-file').set('over-a.fit', 'contain').wire('sky-a.layer -> over-a.bottom'));
    expect(passes(made)).toMatchObject([
      { id: 'sky-a.layer.screen0', samplers: [{ source: { resource: 'sky-a.layer' }, fit: 'contain' }] },
    ]);
    expect(ids(made).slice(-2)).toEqual(['sky-a.layer.screen0', 'scene-a']);
  });

  test('two pictures of their own size are merged in that size, not each laid onto the view', () => {
    const made = program(
      sceneStudio()
        .add('sky-a', 'source/image-file')
        .add('sky-b', 'source/image-file')
        .wire('sky-a.layer -> over-a.top', 'sky-b.layer -> over-a.bottom'),
    );
    expect(passes(made).map(({ id, view, target }) => [id, view, target])).toEqual([
      ['over-a.pass0', 'once', 'over-a.layer'],
      ['over-a.layer.screen0', 'each', 'screen'],
    ]);
  });

  test('the screen says what is behind everything, and whether edges are smooth', () => {
    const studio = sceneStudio().wire('scene-a.layer -> screen-a.layer');
    expect(program(studio).presentation.background).toBe('world');
    studio.set('screen-a.background', 'color').set('screen-a.color', [1, 0, 0, 1]).set('screen-a.antialias', false);
    expect(program(studio).presentation).toEqual({ mode: 'forward', antialias: false, background: [1, 0, 0, 1], blend: 'alpha' });
    expect(program(videoStudio().set('screen-a.background', 'color')).presentation.background).toBe('world');
  });
});

describe('pictures', () => {
  test('a scene that a filter reads is drawn into a picture of four samples, without if edges are rough', () => {
    const studio = blurAfterMerging();
    const scene = (made: Program) => made.resources.find(({ id }) => id === 'scene-a.layer');
    expect(scene(program(studio))).toMatchObject({ kind: 'target', samples: 4, depth: 'window', format: 'rgba8' });
    expect(scene(program(studio.set('screen-a.antialias', false)))).toMatchObject({ samples: 1 });
  });

  test('an occlusion of a merged picture is a pass, which reads the merged depth', () => {
    const studio = arScene()
      .unwire('scene-a.layer -> hide-a.layer')
      .wire('scene-a.layer -> over-b.top', 'over-b.layer -> hide-a.layer', 'hide-a.layer -> screen-a.layer');
    const made = program(studio);
    expect(draws(made).every(({ occlusion }) => occlusion === null)).toBe(true);
    const hide = passes(made).at(-1);
    expect(hide?.id).toBe('hide-a.pass0');
    expect(new Set(hide?.samplers.map(({ source }) => source))).toEqual(
      new Set([
        { kind: 'color', resource: 'over-b.layer' },
        { kind: 'depth', depth: { resource: 'over-b.layer.depth', encoding: 'metres' } },
        { kind: 'room-depth', resource: 'room-a.depth' },
      ]),
    );
  });

  test('a draw with a second reader is not drawn with its occlusion', () => {
    const made = program(
      arScene().add('sepia-a', 'filter/sepia').wire('scene-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> over-a.top'),
    );
    expect(draws(made).find(({ id }) => id === 'scene-a')).toMatchObject({ target: 'scene-a.layer', occlusion: null });
    expect(passes(made).map(({ id }) => id)).toContain('hide-a.pass0');
  });

  test('depth is merged only where somebody reads it', () => {
    expect(targets(program(blurAfterMerging()))).not.toContain('over-a.layer.depth');
    expect(targets(program(fog())).filter((id) => id.endsWith('.depth'))).toEqual(['over-a.layer.depth', 'over-b.layer.depth']);
  });

  test('a filter passes depth through; one that moves pixels, or has another size, loses it, and a reader is told', () => {
    const through = (filter: string) => {
      const studio = emptyStudio()
        .add('box-a', 'objects/primitive')
        .add('scene-a', 'layer/scene')
        .add('first-a', filter)
        .add('fog-a', 'filter/fog')
        .add('screen-a', 'output/screen')
        .wire(
          'box-a.objects -> scene-a.objects',
          'scene-a.layer -> first-a.inputImage',
          'first-a.layer -> fog-a.inputImage',
          'fog-a.layer -> screen-a.layer',
        );
      const depth = passes(program(studio))
        .at(-1)
        ?.samplers.find(({ source }) => source.kind === 'depth');
      return { depth: depth?.source, problems: problems(studio) };
    };
    const kept = { depth: { kind: 'depth', depth: { resource: 'scene-a.layer', encoding: 'window' } }, problems: [] };
    expect(through('filter/sepia')).toEqual(kept);
    expect(through('filter/gaussian-blur')).toEqual(kept);
    const lost = { depth: undefined, problems: [{ code: 'SCR043', severity: 'warning', nodeId: 'fog-a', port: 'inputImage' }] };
    expect(through('filter/swirl')).toEqual(lost);
    expect(through('filter/thumbnail')).toEqual(lost);
  });

  test('pictures of their own size are filtered once for all views, in that size', () => {
    const made = program(imageOnly());
    const image = (id: string) => made.resources.find((resource) => resource.id === id);
    expect(image('sepia-a.layer')).toMatchObject({ domain: 'image', size: { base: 'sky-a.layer' } });
    expect(image('small-a.small')).toMatchObject({
      size: {
        base: 'sepia-a.layer',
        width: [{ op: 'width' }, { slot: made.slots.params['small-a.fraction'] }, { op: '*' }, { op: 'floor' }],
      },
    });
    expect(passes(made).find(({ id }) => id === 'sepia-a.pass0')).toMatchObject({ view: 'once' });
  });

  test('a persistent buffer lasts, in the precision it asks for', () => {
    expect(program(imageOnly()).resources.find(({ id }) => id === 'trails-a.trail')).toMatchObject({
      lifetime: 'persistent',
      format: 'rgba16f',
    });
  });

  test('equal shaders are stored once, whichever nodes they belong to', () => {
    const made = program(subgraphs());
    expect(passes(made).map(({ shader }) => shader)).toEqual([0, 1, 0, 1]);
    expect(made.shaders.map(({ sourceMap }) => sourceMap?.sources)).toEqual([['filters/sepia.fs'], ['filters/sobel-edges.fs']]);
  });

  test('source maps stay at home when they are not wanted', () => {
    expect(program(blurAfterMerging(), { sourceMaps: false }).shaders.every((shader) => !('sourceMap' in shader))).toBe(true);
  });

  test('loops are bounded where it is asked for, and only there', () => {
    const loop =
      '/*{"ISFVSN":"2","INPUTS":[{"NAME":"inputImage","TYPE":"image"}]}*/\nvoid main() { vec4 c = vec4(0.0); for (int i = 0; i < 9; i++) c += IMG_THIS_PIXEL(inputImage); gl_FragColor = c; }';
    const studio = videoStudio()
      .source('loop.fs', loop)
      .add('loop-a', 'filter/loop')
      .wire('video-a.layer -> loop-a.inputImage', 'loop-a.layer -> screen-a.layer');
    const [bounded] = program(studio, { loopBudget: true }).shaders;
    const [plain] = program(studio).shaders;
    expect(bounded?.fragment.length).toBeGreaterThan(plain?.fragment.length ?? 0);
  });
});

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
  test.each([
    ['a track', { track: { keys: [{ timeS: 0, value: 1, easing: 'linear' as const }], repeat: 'once' as const } }],
    ['an expression', { expression: 'sin(time)' }],
  ])('%s is told with node and param, not passed over', (_, binding) => {
    const studio = videoStudio()
      .add('sepia-a', 'filter/sepia')
      .wire('video-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer')
      .bind('sepia-a.amount', binding);
    expect(problems(studio)).toEqual([{ code: 'SCR019', severity: 'error', nodeId: 'sepia-a', port: 'amount' }]);
  });

  test('a node in the making does not stop the picture', () => {
    const studio = videoStudio()
      .add('sepia-a', 'filter/sepia')
      .add('sepia-b', 'filter/sepia')
      .wire('sepia-a.layer -> sepia-b.inputImage')
      .bind('sepia-b.amount', { expression: 'x' });
    expect(program(studio).operations).toEqual([]);
    expect(problems(studio, { taps: ['sepia-b.layer', 'sepia-a.layer'] })).toEqual([
      { code: 'SCR015', severity: 'warning', nodeId: 'sepia-a', port: 'inputImage' },
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
    expect(problems(bomb)).toMatchObject([{ code: 'SCR020', severity: 'error' }]);
  });
});
