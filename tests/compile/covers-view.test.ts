import { describe, expect, test } from '@jest/globals';
import { fixedImageNote } from '../../export/program/fixed-image.ts';
import type { Program } from '../../export/program/program.ts';
import { twins } from '../support/fusion-kit.ts';

const node = (type: string, params: object = {}) => ({ type, version: 1, params });
const PHOTO = { 'photo-a': node('source/image-file', { file: 'photo' }) };
const OPAQUE = { opaqueImages: ['photo'] };
const ALL = ['ar', 'camera', 'authored-vr', 'orbit'];

function chainOf(
  types: readonly (readonly [type: string, params?: object])[],
  more: Readonly<Record<string, string>> = {},
  options = OPAQUE,
) {
  const nodes = Object.fromEntries(types.map(([type, params], i) => [`e-${i}`, node(type, params)]));
  const wires = types.map((_, i) => `${i === 0 ? 'photo-a' : `e-${i - 1}`}.layer -> e-${i}.inputImage`);
  const last = types.length === 0 ? 'photo-a' : `e-${types.length - 1}`;
  return twins({ ...PHOTO, ...nodes }, [...wires, `${last}.layer -> screen-a.layer`], more, options);
}

const tiersOf = ({ tiers }: Program) => tiers.map(({ id }) => id);

describe('a page whose image covers the view', () => {
  test.each([
    ['the photograph alone', []],
    ['effects whose code keeps alpha', [['filter/grey'], ['filter/sepia']]],
    ['effects whose header says it', [['filter/gaussian-blur'], ['filter/swirl'], ['filter/watercolor']]],
    ['an effect with opaque colors', [['filter/halftone', { paperColor: [1, 1, 1, 1] }]]],
  ] as const)('has no sessions to enter: %s', (_, types) => {
    const { separate, fused } = chainOf(types as never);
    for (const program of [separate, fused]) {
      expect(tiersOf(program)).toEqual(['orbit']);
      expect(fixedImageNote(program)).toContain('covers the view');
    }
  });

  test('nor for a video file without transparency', () => {
    const nodes = { 'film-a': node('source/video-file', { file: 'film' }), 'sepia-a': node('filter/sepia') };
    const wires = ['film-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer'];
    expect(tiersOf(twins(nodes, wires, {}, { opaqueImages: ['film'] }).fused)).toEqual(['orbit']);
    expect(tiersOf(twins(nodes, wires, {}, { opaqueImages: [] }).fused)).toEqual(ALL);
  });

  test('nor with a layer over it, however transparent that is', () => {
    const nodes = { ...PHOTO, 'over-a': node('operator/over', { opacity: 0.5 }), 'sepia-a': node('filter/sepia') };
    const wires = ['pattern-a.layer -> over-a.top', 'photo-a.layer -> over-a.bottom', 'over-a.layer -> sepia-a.inputImage'];
    expect(tiersOf(twins(nodes, [...wires, 'sepia-a.layer -> screen-a.layer'], {}, OPAQUE).fused)).toEqual(['orbit']);
    const under = ['photo-a.layer -> over-a.top', 'pattern-a.layer -> over-a.bottom', 'over-a.layer -> sepia-a.inputImage'];
    expect(tiersOf(twins(nodes, [...under, 'sepia-a.layer -> screen-a.layer'], {}, OPAQUE).fused)).toEqual(ALL);
  });
});

describe('sessions stay', () => {
  test.each([
    ['for a file with transparency', [], {}, { opaqueImages: [] }],
    ['for an effect that makes transparency', [['filter/chroma-key']], {}, OPAQUE],
    ['for a transparent color', [['filter/halftone', { paperColor: [1, 1, 1, 0.5] }]], {}, OPAQUE],
    [
      'for a shader of the project that only says so',
      [['filter/own']],
      {
        'own.fs':
          '/*{ "ISFVSN": "2", "SCRIM_OPAQUE": ["inputImage"], "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/\nvoid main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) * 0.5; }',
      },
      OPAQUE,
    ],
  ] as const)('%s', (_, types, sources, options) => {
    expect(tiersOf(chainOf(types as never, sources, options as never).fused)).toEqual(ALL);
  });

  test('for an image that is fitted into the view with borders', () => {
    const nodes = { ...PHOTO, 'mix-a': node('operator/blend', { fit: 'contain' }) };
    const wires = ['pattern-a.layer -> mix-a.top', 'photo-a.layer -> mix-a.bottom', 'mix-a.layer -> screen-a.layer'];
    const sessions = tiersOf(twins(nodes, wires, {}, OPAQUE).fused);
    const covering = { ...nodes, 'mix-a': node('operator/blend') };
    expect([sessions, tiersOf(twins(covering, wires, {}, OPAQUE).fused)]).toEqual([ALL, ['orbit']]);
  });

  test('for objects before the photograph, for the camera, and for a wire that sets a color', () => {
    const scene = { ...PHOTO, 'box-a': node('objects/primitive'), 'scene-a': node('layer/scene'), 'over-a': node('operator/over') };
    const wires = ['box-a.objects -> scene-a.objects', 'scene-a.layer -> over-a.top', 'photo-a.layer -> over-a.bottom'];
    expect(tiersOf(twins(scene, [...wires, 'over-a.layer -> screen-a.layer'], {}, OPAQUE).fused)).toEqual(ALL);
    const camera = { 'camera-a': node('source/camera-video'), 'grey-a': node('filter/grey') };
    const seen = ['camera-a.layer -> grey-a.inputImage', 'grey-a.layer -> screen-a.layer'];
    expect(tiersOf(twins(camera, seen).fused)).toContain('camera');
    const wired = { ...PHOTO, 'color-a': node('value/color'), 'dots-a': node('filter/halftone') };
    const colored = ['color-a.color -> dots-a.paperColor', 'photo-a.layer -> dots-a.inputImage', 'dots-a.layer -> screen-a.layer'];
    expect(tiersOf(twins(wired, colored, {}, OPAQUE).fused)).toEqual(ALL);
  });
});

test('where the files are not known, the note says what decides', () => {
  const { fused } = chainOf([['filter/gaussian-blur']], {}, { opaqueImages: [] });
  expect(fixedImageNote(fused)).toContain('If its files have no transparency');
  expect(fixedImageNote(chainOf([['filter/chroma-key']]).fused)).toBeNull();
});
