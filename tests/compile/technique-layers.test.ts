import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import type { Program } from '../../export/program/program.ts';
import { LIBRARY } from '../support/library.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';
import { draws, ids, passes } from './compiled.ts';

/** A glass ball before a box, each in a scene of its own. */
function glassStudio(): TestStudio {
  return new TestStudio({ library: LIBRARY, readShader })
    .add('box-a', 'objects/primitive')
    .add('back-a', 'layer/scene')
    .add('ball-a', 'objects/primitive', { shape: 'sphere' })
    .add('glass-a', 'technique/glass')
    .add('apply-a', 'objects/apply-technique')
    .add('move-a', 'objects/transform')
    .add('front-a', 'layer/scene')
    .add('over-a', 'operator/over')
    .add('screen-a', 'output/screen')
    .wire('box-a.objects -> back-a.objects', 'back-a.layer -> glass-a.behind', 'ball-a.objects -> apply-a.objects')
    .wire('glass-a.technique -> apply-a.technique', 'apply-a.objects -> move-a.objects', 'move-a.objects -> front-a.objects')
    .wire('back-a.layer -> over-a.bottom', 'front-a.layer -> over-a.top', 'over-a.layer -> screen-a.layer');
}

function compiled(studio: TestStudio): Program {
  const { output, diagnostics } = compile({ project: studio.project, library: studio.library });
  if (!output) throw new Error(JSON.stringify(diagnostics));
  return output;
}

function technique(program: Program) {
  const found = program.resources.find(({ kind }) => kind === 'technique');
  if (found?.kind !== 'technique') throw new Error('There is no technique.');
  return found;
}

describe('a layer at a technique', () => {
  test('is drawn once, before what is drawn with the technique, and that waits for it', () => {
    const program = compiled(glassStudio());
    expect(draws(program).map(({ id, target }) => [id, target])).toEqual([
      ['back-a', 'back-a.layer'],
      ['front-a', 'screen'],
    ]);
    expect(draws(program)[1]?.reads).toContain('back-a.layer');
    expect(ids(program).indexOf('back-a')).toBeLessThan(ids(program).indexOf('front-a'));
    expect(technique(program).samplers).toEqual([{ name: 'a_behind', source: { kind: 'color', resource: 'back-a.layer' }, fit: 'none' }]);
    expect(passes(program).map(({ target }) => target)).toEqual(['screen']);
  });

  test('keeps its layer until then: no other layer gets the texture', () => {
    const studio = glassStudio()
      .unwire('front-a.layer -> over-a.top')
      .add('sepia-a', 'filter/sepia')
      .wire('front-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> over-a.top');
    const shared = compiled(studio).resources.flatMap((resource) => (resource.kind === 'target' && resource.shares ? [resource] : []));
    expect(shared).toEqual([]);
  });

  test('is what asks for the camera where it is the camera’s video', () => {
    const studio = glassStudio()
      .unwire('back-a.layer -> glass-a.behind', 'back-a.layer -> over-a.bottom')
      .add('video-a', 'source/camera-video');
    expect(compiled(studio.wire('video-a.layer -> over-a.bottom')).needs).toEqual([]);
    const sampled = compiled(studio.wire('video-a.layer -> glass-a.behind'));
    expect(sampled.needs).toMatchObject([{ capability: 'camera-image', required: false }]);
    expect(technique(sampled).samplers).toMatchObject([{ source: { resource: 'video-a.layer' } }]);
  });

  test('may be missing where the input is optional', () => {
    expect(technique(compiled(glassStudio().unwire('back-a.layer -> glass-a.behind'))).samplers).toBeUndefined();
  });

  test('that shows the objects drawn with it is a cycle, which is reported; one that shows the previous frame is not', () => {
    const studio = glassStudio().unwire('back-a.layer -> glass-a.behind');
    expect(() => studio.wire('front-a.layer -> glass-a.behind')).toThrow(
      'SCR014: This wire would close a loop: front-a → glass-a → apply-a → move-a → front-a. Add a delay to the loop',
    );
    const delayed = studio
      .add('before-a', 'layer/previous-frame')
      .wire('front-a.layer -> before-a.layer', 'before-a.layer -> glass-a.behind');
    expect(technique(compiled(delayed)).samplers).toMatchObject([{ source: { resource: 'before-a.layer' } }]);
  });

  test('of a picture’s own size is laid onto the view, or is a texture where the technique says so', () => {
    const studio = glassStudio()
      .unwire('back-a.layer -> glass-a.behind')
      .add('photo-a', 'source/image-file')
      .wire('photo-a.layer -> glass-a.behind')
      .add('toon-a', 'technique/toon')
      .add('styled-a', 'objects/apply-technique')
      .wire('photo-a.layer -> toon-a.ramp', 'box-a.objects -> styled-a.objects', 'toon-a.technique -> styled-a.technique')
      .unwire('box-a.objects -> back-a.objects')
      .wire('styled-a.objects -> back-a.objects');
    const fits = compiled(studio).resources.flatMap((resource) =>
      resource.kind === 'technique' ? [[resource.id, resource.samplers?.[0]?.fit]] : [],
    );
    expect(fits).toEqual([
      ['glass-a.technique', 'cover'],
      ['toon-a.technique', 'none'],
    ]);
  });
});

test('a technique of the project may read the library’s images, and a missing one is reported', () => {
  const text = (path: string) =>
    `/*{ "INPUTS": [],\n"IMPORTED": { "strokes": { "PATH": "${path}" } } }*/\nvec4 surface(const in Surface s) { return texture(strokes, s.uv); }`;
  const studio = (path: string) =>
    glassStudio()
      .source('mine.glsl', text(path))
      .add('mine-a', 'technique/mine')
      .unwire('glass-a.technique -> apply-a.technique')
      .wire('mine-a.technique -> apply-a.technique');
  expect(technique(compiled(studio('pictures/hatching-light.png'))).pictures).toMatchObject([
    { name: 'a_strokes', data: expect.stringMatching(/^iVBOR/) },
  ]);
  const { project, library } = studio('pictures/none.png');
  const { output, diagnostics } = compile({ project, library });
  expect(output).toBeNull();
  expect(diagnostics).toEqual([expect.objectContaining({ code: 'SCR043', nodeId: 'mine-a', file: 'shaders/mine.glsl', line: 2 })]);
});
