import { expect, test } from '@jest/globals';
import { passes, twins } from '../../../tests/support/fusion-kit.ts';

const NODES = {
  'blur-a': { type: 'filter/gaussian-blur', version: 1, params: { radius: 3 } },
  'video-a': { type: 'source/camera-video', version: 1 },
  'blend-a': { type: 'operator/blend', version: 1 },
  'blend-b': { type: 'operator/blend', version: 1 },
};

/** A blurred pattern under the camera image, and the pattern again over both. */
const WIRES = [
  'pattern-a.layer -> blur-a.inputImage',
  'blur-a.layer -> blend-a.bottom',
  'video-a.layer -> blend-a.top',
  'blend-a.layer -> blend-b.bottom',
  'pattern-a.layer -> blend-b.top',
  'blend-b.layer -> screen-a.layer',
];

function drawnOnce(options = {}): string[] {
  return passes(twins(NODES, WIRES, {}, options).separate).flatMap(({ id, sameForViews }) => (sameForViews ? [id] : []));
}

test('views of equal size share what does not depend on the camera', () => {
  const all = passes(twins(NODES, WIRES).separate).map(({ id }) => id);
  expect(all).toEqual(['pattern-a.pass0', 'blur-a.pass0', 'blur-a.pass1', 'blend-a.pass0', 'blend-b.pass0']);
  expect(drawnOnce()).toEqual(['pattern-a.pass0', 'blur-a.pass0', 'blur-a.pass1']);
});

test('but not a pattern that reads the pose of its view', () => {
  const sources = {
    'pattern.fs': '/*{ "ISFVSN": "2" }*/ void main() { gl_FragColor = vec4(SCRIM_WORLD_FROM_VIEW[3].xyz, 1.0); }',
  };
  const shared = passes(twins(NODES, WIRES, sources).separate).filter(({ sameForViews }) => sameForViews);
  expect(shared).toEqual([]);
});

test('nor a layer that the editor views, which has a texture for each view, nor what reads it', () => {
  expect(drawnOnce({ taps: ['pattern-a.layer'] })).toEqual([]);
});

test('nor a layer over whose texture another pass draws later', () => {
  // Of two layers in one texture, the second one reads the camera.
  const nodes = { ...NODES, 'grey-a': { type: 'filter/grey', version: 1 }, 'blur-b': NODES['blur-a'] };
  const wires = [
    'pattern-a.layer -> grey-a.inputImage',
    'grey-a.layer -> blend-a.bottom',
    'video-a.layer -> blend-a.top',
    'blend-a.layer -> blur-b.inputImage',
    'blur-b.layer -> screen-a.layer',
  ];
  const { resources, operations } = twins(nodes, wires).separate;
  const textureOf = (id: string) => {
    const target = resources.find((resource) => resource.id === id);
    return target?.kind === 'target' ? (target.shares ?? target.id) : null;
  };
  const later = operations.flatMap(({ writes }) => writes).slice(2);
  expect(later.map(textureOf)).toContain(textureOf('grey-a.layer'));
  expect(operations.flatMap((operation) => (operation.kind === 'pass' && operation.sameForViews ? [operation.id] : []))).toEqual([]);
});
