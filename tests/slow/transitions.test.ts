import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import { readTransition } from '../../export/glsl/transition/read-transition.ts';
import { drawPicture, made, PAGE, paint, toPage } from '../browser/glsl-kit.ts';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';

const page = useModule(PAGE);

const WIDTH = 32;
const HEIGHT = 18;
const FROM = paint(WIDTH, HEIGHT, (x, y) => [x * 7, 40, y * 13, 255]);
const TO = paint(WIDTH, HEIGHT, (x, y) => [200, y * 12, 255 - x * 7, 255]);
/** For those that take a third image: gray from black to white. */
const MAP = paint(WIDTH, HEIGHT, (x) => [x * 8, x * 8, x * 8, 255]);

/** Draws a transition at a progress. */
function renderer(source: string, file: string): (progress: number) => Promise<RgbaImage> {
  const shader = made(readTransition(source, file));
  const images = shader.inputs.filter(({ type }) => type === 'image').map(({ name }) => name);
  const job = {
    width: WIDTH,
    height: HEIGHT,
    passes: made(linkIsf(shader, { node: 'test' })),
    pictures: Object.fromEntries(images.map((name) => [name, toPage(name === 'startImage' ? FROM : name === 'endImage' ? TO : MAP)])),
  };
  const params = Object.fromEntries(shader.inputs.map((input) => [input.name, input.default]));
  return (progress) => drawPicture(page, { ...job, params: { ...params, progress } });
}

/** Of any channel, as a number from 0 to 255. */
function largestDifference(a: RgbaImage, b: RgbaImage): number {
  return a.data.reduce((most, value, i) => Math.max(most, Math.abs(value - (b.data[i] ?? 0))), 0);
}

describe('transitions of gl-transitions.com', () => {
  const FOLDER = 'node_modules/gl-transitions/transitions';
  const files = readdirSync(FOLDER).filter((name) => name.endsWith('.glsl'));

  test('all are there', () => expect(files).toHaveLength(125));

  /** By their own arithmetic, these are elsewhere at an end. */
  const EXCEPTIONS = [
    // Its random number is 0 in the block of the corner, and so counts as passed at progress 0.
    'BlockDissolve.glsl at 0',
    // Turns by 225° each way, and its smooth edge reaches further: at progress 0 it touches the left.
    'Radial.glsl at 0',
  ];

  test('all draw; at 0 there is the first picture, at 1 the second', async () => {
    const off: string[] = [];
    for (const file of files) {
      const render = renderer(readFileSync(join(FOLDER, file), 'utf8'), file);
      const start = await render(0);
      await render(0.5);
      const end = await render(1);
      if (largestDifference(start, FROM) > 2) off.push(`${file} at 0`);
      if (largestDifference(end, TO) > 2) off.push(`${file} at 1`);
    }
    expect(off).toEqual(EXCEPTIONS);
  });
});

test('params, whole numbers and what stands outside of functions are as written', async () => {
  const source = `uniform ivec2 size; // = ivec2(2, 1)
uniform vec3 color; // = vec3(1.0, 0.5, 0.0)
uniform vec4 steps; // = vec4(0.25, 0.0, 0.0, 0.0)
uniform float progress;
float late = progress * 0.5;
int half_ = size.x / 2;
vec4 transition(vec2 p) { return vec4(color.g * late * float(half_), steps.x, ratio / 4.0, 1); }`;
  expect(pixelAt(await renderer(source, 'own.glsl')(1), 3, 3)).toEqual([64, 64, 113, 255]);
});
