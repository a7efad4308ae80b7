import { expect, test } from '@jest/globals';
import { program } from '../../../tests/compile/compiled.ts';
import { videoStudio } from '../../../tests/compile/graphs.ts';

const shader = (credit: string) =>
  `/*{ "ISFVSN": "2", "CREDIT": "${credit}", "LICENSE": "CC BY 4.0", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) * 0.5; }`;

test('credits name each work that the screen depends on, once, with its nodes, and none that it does not', () => {
  const studio = videoStudio()
    .source('rings.fs', shader('Ada'))
    .source('waves.fs', shader('Bob'))
    .add('rings-a', 'filter/rings')
    .add('rings-b', 'filter/rings')
    .add('waves-a', 'filter/waves')
    .wire(
      'video-a.layer -> rings-a.inputImage',
      'rings-a.layer -> rings-b.inputImage',
      'rings-b.layer -> screen-a.layer',
      'video-a.layer -> waves-a.inputImage',
    );
  expect(program(studio).credits).toEqual([
    { title: 'Rings', kind: 'effect', credit: 'Ada', licence: 'CC BY 4.0', nodes: ['rings-a', 'rings-b'] },
  ]);
  expect(program(videoStudio()).credits).toBeUndefined();
});

test('assets come under the terms that the project names', () => {
  const studio = videoStudio()
    .asset('photo', { path: 'assets/photo.png', kind: 'image', credit: 'Cy', licence: 'CC0' })
    .add('picture-a', 'source/image-file', { image: 'photo' })
    .wire('picture-a.layer -> screen-a.layer');
  expect(program(studio).credits).toEqual([
    { title: 'assets/photo.png', kind: 'asset', credit: 'Cy', licence: 'CC0', nodes: ['picture-a'] },
  ]);
});
