import { describe, expect, test } from '@jest/globals';
import { asked, draws, ids, passes, program, targets } from '../../../tests/compile/compiled.ts';
import { arScene, blurAfterMerging, sceneStudio, videoStudio } from '../../../tests/compile/graphs.ts';
import { TEST_LIBRARY as library } from '../../../tests/support/test-library.ts';
import { compile } from '../compile.ts';

describe('least privilege', () => {
  test('a video that is only the background requests no feature and has no operation', () => {
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

  test('a node that nothing on screen depends on requests no feature', () => {
    expect(program(videoStudio().add('room-a', 'world/depth')).needs).toEqual([]);
  });

  test('what is looked at is asked for too, and is no more than looked at', () => {
    const made = program(videoStudio(), { taps: ['video-a.layer'] });
    expect(asked(made)).toEqual(['camera-image']);
    expect(made.presentation).toMatchObject({ background: 'world', mode: 'forward' });
    expect(made.taps).toEqual({ 'video-a.layer': { color: 'video-a.layer', depth: null } });
  });

  test('a required need leaves out the tiers that lack it, but looking around', () => {
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
    expect(output?.tiers).toMatchObject([
      { id: 'ar', without: [] },
      { id: 'orbit', without: [{ capability: 'depth' }] },
    ]);
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

  test('every light wired to a layer has a map', () => {
    const made = program(
      arScene().add('sun-b', 'light/directional').wire('sun-b.lights -> scene-a.lights', 'sun-b.lights -> shadow-a.lights'),
    );
    const maps = made.operations.filter((operation) => operation.kind === 'shadow-maps');
    expect(maps.map(({ lights }) => lights)).toEqual([['sun-a.lights', 'sun-b.lights']]);
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

  test('an occlusion followed by pointwise filters stays in its draw; the filters are one pass onto the screen, which other scenes are drawn to', () => {
    const filtered = arScene()
      .add('sepia-a', 'filter/sepia')
      .add('sepia-b', 'filter/sepia')
      .wire('hide-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> sepia-b.inputImage', 'sepia-b.layer -> over-b.top');
    const made = program(filtered, { fuse: true });
    expect(draws(made).map(({ id, target, occlusion }) => [id, target, occlusion?.node ?? null])).toEqual([
      ['scene-a', 'hide-a.layer', 'hide-a'],
      ['shadow-a', 'screen', null],
    ]);
    expect(passes(made)).toMatchObject([{ target: 'screen', blend: 'over', samplers: [{ source: { resource: 'hide-a.layer' } }] }]);
    expect(targets(made)).toEqual(['hide-a.layer']);
    // The camera image is only shown, not read.
    expect(asked(made)).toEqual(['depth']);
    expect(passes(program(filtered, { fuse: false }))).toHaveLength(2);
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
    expect(program(studio).presentation).toEqual({
      mode: 'forward',
      antialias: false,
      background: [1, 0, 0, 1],
      blend: 'alpha',
      screenDepth: 'whole',
      covers: true,
    });
    expect(program(videoStudio().set('screen-a.background', 'color')).presentation.background).toBe('world');
  });

  test('has a depth buffer where objects are drawn to it, which headsets get where it shows all of them', () => {
    const depthOf = (studio: Parameters<typeof program>[0]) => program(studio).presentation.screenDepth ?? 'partial';
    expect(depthOf(blurAfterMerging())).toBe('none');
    // The shadow is drawn first, and its depth is cleared for the scene.
    expect(depthOf(arScene())).toBe('partial');
  });
});
