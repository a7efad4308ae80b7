import { describe, expect, test } from '@jest/globals';
import { TEST_LIBRARY as base, readShader } from '../../../tests/support/test-library.ts';
import { TestStudio } from '../../../tests/support/test-studio.ts';
import { printWire } from '../wires.ts';
import { forkShader, removeSource } from './shader-commands.ts';

interface Input {
  readonly NAME: string;
  readonly TYPE: string;
  readonly DEFAULT?: unknown;
}

const image = (NAME: string): Input => ({ NAME, TYPE: 'image' });
const float = (NAME: string): Input => ({ NAME, TYPE: 'float', DEFAULT: 0.5 });

function shader(...INPUTS: Input[]): string {
  return `/*${JSON.stringify({ ISFVSN: '2', INPUTS })}*/\nvoid main() { gl_FragColor = vec4(1.0); }\n`;
}

/** video → edge (the project's own) → screen, with one param set and one wired. */
function edgeStudio(): TestStudio {
  return new TestStudio({ library: base, readShader })
    .source('edge.fs', shader(image('inputImage'), float('low'), float('high')))
    .add('video-aaaa', 'source/camera-video')
    .add('edge-aaaa', 'filter/edge', { low: 0.25 })
    .add('number-aaaa', 'value/number')
    .add('screen-aaaa', 'output/screen')
    .wire('video-aaaa.layer -> edge-aaaa.inputImage', 'number-aaaa.value -> edge-aaaa.high', 'edge-aaaa.layer -> screen-aaaa.layer');
}

const wires = (studio: TestStudio) => (studio.project.graphs.main?.wires ?? []).map(printWire);
const edge = (studio: TestStudio) => studio.project.graphs.main?.nodes['edge-aaaa'];

describe('editing a shader of the project', () => {
  test('its body changes nothing but the text', () => {
    const studio = edgeStudio();
    const graphs = studio.project.graphs;
    studio.source('edge.fs', `${studio.project.sources['edge.fs']}\n// done`);
    expect(studio.project.graphs).toBe(graphs);
  });

  test('wires and params stay whose name and type are still there; the rest goes, all as one step', () => {
    const studio = edgeStudio();
    const before = studio.save();
    const steps = studio.history.past.length;
    studio.source('edge.fs', shader(image('inputImage'), { NAME: 'low', TYPE: 'color', DEFAULT: [0, 0, 0, 1] }, float('threshold')));
    expect(wires(studio)).toEqual(['video-aaaa.layer -> edge-aaaa.inputImage', 'edge-aaaa.layer -> screen-aaaa.layer']);
    expect(edge(studio)?.params).toEqual({});
    expect(studio.history.past).toHaveLength(steps + 1);
    expect(studio.diagnostics()).toEqual([]);
    expect(studio.undo().save()).toEqual(before);
  });

  test('an input with another name takes its wires, its value and the port outside along, as one step', () => {
    const studio = edgeStudio();
    const before = studio.save();
    const steps = studio.history.past.length;
    studio.source('edge.fs', shader(image('picture'), float('low'), float('high')));
    expect(wires(studio)).toContain('video-aaaa.layer -> edge-aaaa.picture');
    expect(studio.history.past).toHaveLength(steps + 1);
    studio.source('edge.fs', shader(image('picture'), float('least'), float('high')));
    expect(edge(studio)?.params).toMatchObject({ least: { value: 0.25 } });
    studio.source('edge.fs', shader(image('picture'), float('least'), float('most')));
    expect(wires(studio)).toContain('number-aaaa.value -> edge-aaaa.most');
    expect(studio.diagnostics()).toEqual([]);
    expect(studio.undo().undo().undo().save()).toEqual(before);
  });

  test('a name that another input had is no new name, and neither is one of another type', () => {
    const swapped = edgeStudio().source('edge.fs', shader(image('inputImage'), float('high'), float('low')));
    expect(edge(swapped)?.params).toMatchObject({ low: { value: 0.25 } });
    const retyped = edgeStudio().source('edge.fs', shader(image('inputImage'), { NAME: 'least', TYPE: 'bool' }, float('high')));
    expect(Object.keys(edge(retyped)?.params ?? {})).toEqual(['high']);
  });

  test('a second image makes an operator of a filter, its nodes included', () => {
    const studio = edgeStudio().source('edge.fs', shader(image('inputImage'), image('mask'), float('low'), float('high')));
    expect(edge(studio)).toMatchObject({ type: 'operator/edge', params: { low: { value: 0.25 } } });
    expect(wires(studio)).toHaveLength(3);
    expect(studio.diagnostics()).toMatchObject([{ code: 'SCR015', port: 'mask' }]);
    studio.source('edge.fs', shader(float('low')));
    expect(edge(studio)?.type).toBe('generator/edge');
    expect(wires(studio)).toEqual(['edge-aaaa.layer -> screen-aaaa.layer']);
  });

  test('a broken header keeps every wire for when it is mended, even into another kind', () => {
    const studio = edgeStudio();
    const whole = studio.save();
    studio.source('edge.fs', '/*{ "INPUTS": [ */ void main() {}');
    expect(wires(studio)).toHaveLength(3);
    expect(studio.library.diagnostics).toMatchObject([{ code: 'SCR040', file: 'shaders/edge.fs' }]);
    studio.source('edge.fs', whole.sources['edge.fs'] ?? '');
    expect(studio.save()).toEqual(whole);
    studio.source('edge.fs', 'broken').source('edge.fs', shader(image('inputImage'), image('other')));
    expect(edge(studio)?.type).toBe('operator/edge');
  });

  test('a file in use is not removed, unless the library has the type too', () => {
    const studio = edgeStudio();
    const remove = (file: string) => studio.attempt((p) => removeSource(p, { base, readShader, file }));
    expect(remove('edge.fs')).toMatchObject([{ code: 'SCR010', nodeId: 'edge-aaaa' }]);
    studio.source('sepia.fs', shader(image('inputImage'), float('mine'))).add('sepia-aaaa', 'filter/sepia', { mine: 1 });
    expect(remove('sepia.fs')).toEqual([]);
    expect(studio.project.graphs.main?.nodes['sepia-aaaa']?.params).toEqual({});
  });
});

describe('copying a shader of the library into the project', () => {
  test('the node uses the copy, wires and params stay, and it is one step', () => {
    const studio = new TestStudio({ library: base, readShader })
      .add('video-aaaa', 'source/camera-video')
      .add('sepia-aaaa', 'filter/sepia', { amount: 0.5 })
      .add('sepia-bbbb', 'filter/sepia')
      .add('screen-aaaa', 'output/screen')
      .wire('video-aaaa.layer -> sepia-aaaa.inputImage', 'sepia-aaaa.layer -> screen-aaaa.layer');
    const before = studio.save();
    const { library } = studio;
    studio.run((p) => forkShader(p, { library, graph: 'main', node: 'sepia-aaaa' }));
    expect(studio.project.sources).toEqual({ 'sepia-2.fs': base.shader('filters/sepia.fs') });
    expect(studio.project.graphs.main?.nodes['sepia-aaaa']).toEqual({
      type: 'filter/sepia-2',
      version: 1,
      params: { amount: { value: 0.5 } },
    });
    expect(studio.project.graphs.main?.nodes['sepia-bbbb']?.type).toBe('filter/sepia');
    expect(studio.diagnostics().filter(({ severity }) => severity === 'error')).toEqual([]);
    expect(studio.undo().save()).toEqual(before);
    expect(studio.redo().save().sources).toHaveProperty(['sepia-2.fs']);
  });

  test('names are free, given or found', () => {
    const studio = new TestStudio({ library: base, readShader }).add('sepia-aaaa', 'filter/sepia').add('scene-aaaa', 'layer/scene');
    const fork = (node: string, name?: string) =>
      studio.attempt((p) => forkShader(p, { library: studio.library, graph: 'main', node, ...(name === undefined ? {} : { name }) }));
    expect(fork('sepia-aaaa', 'sobel-edges')).toMatchObject([{ code: 'SCR002' }]);
    expect(fork('sepia-aaaa', '../x')).toMatchObject([{ code: 'SCR002' }]);
    expect(fork('scene-aaaa')).toMatchObject([{ code: 'SCR043' }]);
    expect(fork('sepia-aaaa', 'old film')).toEqual([]);
    expect(fork('sepia-aaaa')).toEqual([]);
    expect(Object.keys(studio.project.sources)).toEqual(['old film.fs', 'old film-2.fs']);
  });
});
