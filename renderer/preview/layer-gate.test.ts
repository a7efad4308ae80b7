import { expect, test } from '@jest/globals';
import type { Program } from '../../export/program/program.ts';
import { LIBRARY } from '../../tests/support/library.ts';
import { readShader } from '../../tests/support/test-library.ts';
import { TestStudio } from '../../tests/support/test-studio.ts';
import { createLayerGate } from './layer-gate.ts';

/** A box over the camera video, with thumbnails of all layers; a second scene is not connected. */
function program(thumbnails: readonly string[]): Program {
  const studio = new TestStudio({ library: LIBRARY, readShader })
    .add('video-a', 'source/camera-video')
    .add('box-a', 'objects/primitive')
    .add('scene-a', 'layer/scene')
    .add('over-a', 'operator/over')
    .add('screen-a', 'output/screen')
    .add('spare-a', 'layer/scene')
    .add('sepia-a', 'filter/sepia')
    .add('previous-a', 'layer/previous-frame')
    .wire('box-a.objects -> scene-a.objects', 'scene-a.layer -> over-a.top', 'video-a.layer -> over-a.bottom')
    .wire('over-a.layer -> screen-a.layer', 'box-a.objects -> spare-a.objects', 'spare-a.layer -> sepia-a.inputImage')
    .wire('sepia-a.layer -> previous-a.layer');
  const { output } = studio.compile({ thumbnails });
  if (!output) throw new Error('The program has errors.');
  return output;
}

const NOTHING = { left: null, right: null, probed: null };

test('what only thumbnails need is drawn in the frames that read it; the output in all', () => {
  const all = program(['scene-a.layer', 'over-a.layer', 'sepia-a.layer', 'spare-a.layer']);
  const gate = createLayerGate();
  gate.follow(all);
  const drawnNodes = () => {
    const drawn = all.operations.filter((operation) => operation.kind === 'pass' || operation.kind === 'draw');
    return [...new Set(drawn.filter((operation) => gate.isDrawn(operation)).map(({ node }) => node))].sort();
  };
  gate.show(NOTHING, []);
  expect(drawnNodes()).toEqual(['scene-a']);
  gate.show(NOTHING, ['sepia-a.layer']);
  expect(drawnNodes()).toEqual(['scene-a', 'sepia-a', 'spare-a']);
  gate.show(NOTHING, ['over-a.layer', 'spare-a.layer']);
  expect(drawnNodes()).toEqual(['over-a', 'scene-a', 'spare-a']);
  gate.show({ ...NOTHING, right: 'over-a.layer' }, ['spare-a.layer']);
  expect(drawnNodes()).toEqual(['over-a', 'scene-a', 'spare-a']);
});

test('thumbnails do not change what a program requests, which devices play it, or which earlier frames it depends on', () => {
  const { needs, tiers, presentation } = program([]);
  const viewed = program(['video-a.layer', 'sepia-a.layer', 'previous-a.layer']);
  expect(Object.keys(viewed.taps)).toEqual(['sepia-a.layer', 'video-a.layer']);
  // A render of one frame would have to play all earlier ones.
  expect(viewed.operations.some(({ node }) => node === 'previous-a')).toBe(false);
  expect({ needs: viewed.needs, tiers: viewed.tiers, presentation: viewed.presentation }).toEqual({ needs, tiers, presentation });
});
