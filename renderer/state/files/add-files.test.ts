import { expect, test } from '@jest/globals';
import { acceptedNames, kindOfFile } from './add-files.ts';

test.each([
  ['Robot.GLB', 'model'],
  ['photo.jpeg', 'image'],
  ['Clip.MP4', 'video'],
  ['sticker.webm', 'video'],
  ['sky.hdr', 'environment'],
  ['studio.EXR', 'environment'],
  ['garden.ply', 'splats'],
  ['Vase.SOG', 'splats'],
  ['edge.fs', 'shader'],
  ['notes.txt', null],
])('%s is dropped as %s', (name, kind) => {
  expect(kindOfFile(name)).toBe(kind);
});

test('a panorama may be chosen among ordinary pictures, a video may not', () => {
  expect(acceptedNames('environment').split(',')).toEqual(['.hdr', '.exr', '.jpg', '.jpeg', '.png', '.webp', '.avif']);
  expect(acceptedNames('video')).not.toContain('.jpg');
});
