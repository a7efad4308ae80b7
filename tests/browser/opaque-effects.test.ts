import { describe, expect, test } from '@jest/globals';
import type { IsfInput, IsfShader } from '../../export/glsl/isf/isf-shader.ts';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import { createRandom } from '../../export/runtime/random.ts';
import { useModule } from '../support/browser.ts';
import { pixelAt } from '../support/image.ts';
import { made, PAGE, paint } from './glsl-kit.ts';
import { applyShader, type Params, SHADERS } from './shader-library-kit.ts';

const page = useModule(PAGE);

const { next } = createRandom(7, 'opaque effects');

const [WIDTH, HEIGHT] = [40, 30];

function noise(isOpaque: boolean) {
  return paint(WIDTH, HEIGHT, () => {
    const alpha = isOpaque ? 1 : next();
    const channel = () => Math.round(255 * alpha * next());
    return [channel(), channel(), channel(), Math.round(255 * alpha)];
  });
}

/** Params whose place in their range a function tells; all colors are opaque. */
function paramsAt({ inputs }: IsfShader, place: () => number): Params {
  return Object.fromEntries(inputs.flatMap((input) => (input.type === 'image' ? [] : [[input.name, valueAt(input, place)]])));
}

function valueAt({ type, min, max, choices, default: initial }: IsfInput, place: () => number): readonly number[] {
  switch (type) {
    case 'long':
      return choices.length === 0 ? initial : [choices[Math.min(Math.floor(place() * choices.length), choices.length - 1)]?.value ?? 0];
    case 'bool':
      return [Math.round(place())];
    case 'color':
      return initial.map((_, i) => (i === 3 ? 1 : place()));
    case 'float':
    case 'point2D':
      return initial.map((value, i) => {
        const [from, to] = [min?.[i] ?? value, max?.[i] ?? value];
        return from + place() * (to - from);
      });
    default:
      return initial;
  }
}

/** The least alpha that an effect gives with its defaults, at both ends of its params and between them. */
async function leastAlpha(file: string, shader: IsfShader, opaque: readonly string[]): Promise<number> {
  const images = shader.inputs.filter(({ type }) => type === 'image');
  let least = 255;
  for (const place of [null, () => 0, () => 1, next, next, next]) {
    const pictures = Object.fromEntries(images.map(({ name }) => [name, noise(opaque.includes(name))]));
    const drawn = await applyShader(page, file, pictures, place === null ? {} : paramsAt(shader, place));
    for (let y = 0; y < HEIGHT; y++) for (let x = 0; x < WIDTH; x++) least = Math.min(least, pixelAt(drawn, x, y)[3]);
  }
  return least;
}

/** Effects that say nothing although their output may be opaque: of a gradient's stops, of the camera and of depth. */
const SILENT = ['filters/gradient-map.fs', 'filters/room-drawing.fs', 'operators/match-camera.fs', 'operators/sketched-occlusion.fs'];

const effects = Object.keys(SHADERS)
  .filter((file) => !file.startsWith('generators/') && file !== 'filters/to-scene.fs')
  .map((file) => ({ file, shader: made(readIsf(SHADERS[file] ?? '', file)) }));

/** Whether the code of the last pass says that opaque images give an opaque output. */
function isProven(shader: IsfShader): boolean {
  const parts = made(linkIsf(shader, { node: 'test' })).at(-1)?.parts;
  return typeof parts === 'object' && (parts.isOpaque || parts.keptAlpha !== null);
}

const saying = effects.filter(({ shader }) => shader.opaqueImages.length > 0);

describe('effects that name the images which decide whether their output is opaque', () => {
  test.each(saying)('$file is right', async ({ file, shader }) => {
    const images = shader.inputs.flatMap(({ name, type }) => (type === 'image' ? [name] : []));
    expect(images).toEqual(expect.arrayContaining([...shader.opaqueImages]));
    expect(isProven(shader)).toBe(false);
    expect(await leastAlpha(file, shader, shader.opaqueImages)).toBe(255);
  });
});

const others = effects.filter(({ file, shader }) => shader.opaqueImages.length === 0 && !SILENT.includes(file) && !isProven(shader));

test.each(others)('$file says nothing, and may give transparency to opaque images', async ({ file, shader }) => {
  const all = shader.inputs.map(({ name }) => name);
  expect(await leastAlpha(file, shader, all)).toBeLessThan(255);
});
