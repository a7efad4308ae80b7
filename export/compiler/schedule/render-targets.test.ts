import { describe, expect, test } from '@jest/globals';
import type { Program } from '../../../export/program/program.ts';
import { draws, passes, problems, program, targets } from '../../../tests/compile/compiled.ts';
import { arScene, blurAfterMerging, emptyStudio, fog, imageOnly, subgraphs, videoStudio } from '../../../tests/compile/graphs.ts';

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
        { kind: 'depth', depth: { resource: 'over-b.layer.depth', encoding: 'meters' } },
        { kind: 'room-depth', resource: 'room-a.depth' },
      ]),
    );
  });

  test('a scene with a second reader is drawn twice: hidden onto the screen, and whole for the other', () => {
    const twice = () => arScene().add('sepia-a', 'filter/sepia').wire('scene-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> over-a.top');
    const made = program(twice());
    const ofScene = draws(made).filter(({ node }) => node === 'scene-a');
    expect(ofScene).toMatchObject([
      { id: 'scene-a', target: 'scene-a.layer', occlusion: null },
      { id: 'hide-a', target: 'screen', occlusion: { node: 'hide-a' } },
    ]);
    expect(passes(made).map(({ id }) => id)).toEqual(['sepia-a.pass0']);
    const nearer = program(
      twice()
        .add('hide-b', 'layer/depth-occlusion')
        .add('over-c', 'operator/over')
        .wire('scene-a.layer -> hide-b.layer', 'room-a.depth -> hide-b.depth')
        .wire('hide-b.layer -> over-c.top', 'over-b.layer -> over-c.bottom', 'over-c.layer -> screen-a.layer'),
    );
    expect(draws(nearer).map(({ id, target }) => [id, target])).toEqual([
      ['scene-a', 'scene-a.layer'],
      ['hide-a', 'screen'],
      ['hide-b', 'screen'],
    ]);
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
      format: 'rgba32f',
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
      '/*{"ISFVSN":"2","INPUTS":[{"NAME":"inputImage","TYPE":"image"}]}*/\nvoid main() { vec4 c = vec4(0.0); while (c.a < 0.5) c += IMG_THIS_PIXEL(inputImage) + 0.1; gl_FragColor = c; }';
    const studio = videoStudio()
      .source('loop.fs', loop)
      .add('loop-a', 'filter/loop')
      .wire('video-a.layer -> loop-a.inputImage', 'loop-a.layer -> screen-a.layer');
    const [bounded] = program(studio, { loopBudget: true }).shaders;
    const [plain] = program(studio).shaders;
    expect([bounded, plain].map((shader) => shader?.fragment.includes('scrim_spend'))).toEqual([true, false]);
  });
});
