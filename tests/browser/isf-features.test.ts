import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import type { DrawJob } from './glsl.page.ts';
import { drawPicture, linkText, PAGE, paint, toPage } from './glsl-kit.ts';

const page = useModule(PAGE);

const IMAGE = { NAME: 'inputImage', TYPE: 'image' };

function header(fields: Readonly<Record<string, unknown>>): string {
  return `/*${JSON.stringify({ ISFVSN: '2', ...fields })}*/\n`;
}

interface RenderOptions extends Partial<DrawJob> {
  readonly vertex?: string;
  readonly loopBudget?: boolean;
}

function render(source: string, { vertex, loopBudget = false, ...job }: RenderOptions = {}): Promise<RgbaImage> {
  return drawPicture(page, { width: 8, height: 8, ...job, passes: linkText(source, { loopBudget }, 'test.fs', vertex ?? null) });
}

describe('vertex shaders', () => {
  const squares = paint(8, 8, (x, y) => [x * 30, y * 30, 0, 255]);

  test('hand on what they compute at the corners, arrays and matrices too', async () => {
    const vertex = `varying vec2 left; varying vec2 places[2]; varying mat2 turn; varying float unused;
void main() {
  isf_vertShaderInit();
  left = clamp(isf_FragNormCoord - vec2(1.0 / RENDERSIZE.x, 0), 0.0, 1.0);
  for (int i = 0; i < 2; i++) places[i] = isf_FragNormCoord * float(i + 1) * strength;
  turn = mat2(0.0, 1.0, -1.0, 0.0);
}`;
    const source = `${header({ INPUTS: [IMAGE, { NAME: 'strength', TYPE: 'float' }] })}#if __VERSION__ <= 120
varying vec2 left; varying vec2 places[2]; varying mat2 turn;
#else
in vec2 left; in vec2 places[2]; in mat2 turn;
#endif
void main() { gl_FragColor = vec4(left.x, places[1].x - places[0].x, (turn * vec2(0.25, 0.5)).y, 1.0); }`;
    for (const loopBudget of [false, true]) {
      const picture = await render(source, { vertex, loopBudget, pictures: { inputImage: toPage(squares) }, params: { strength: 0.5 } });
      // Clamped at the left corners alone: from 0 to 7/8 across the quad.
      expect(pixelAt(picture, 4, 2)[0]).toBeCloseTo(((4.5 / 8) * 7 * 255) / 8, -0.5);
      expect(pixelAt(picture, 4, 2)[1]).toBeCloseTo((4.5 / 8) * 0.5 * 255, -0.5);
      expect(pixelAt(picture, 4, 2).slice(2)).toEqual([64, 255]);
    }
  });

  test('may move the place of the picture, and the corners', async () => {
    const source = `${header({ INPUTS: [IMAGE] })}void main() { gl_FragColor = IMG_THIS_NORM_PIXEL(inputImage); }`;
    const pictures = { inputImage: toPage(squares) };
    const turned = await render(source, {
      vertex: 'void main() { vv_vertShaderInit(); isf_FragNormCoord.x = 1.0 - isf_FragNormCoord.x; }',
      pictures,
    });
    expect(turned).toEqual(paint(8, 8, (x, y) => [(7 - x) * 30, y * 30, 0, 255]));
    const half = await render(source, {
      vertex: 'void main() { isf_vertShaderInit(); gl_Position.x = gl_Position.x * 0.5 - 0.5; }',
      pictures,
    });
    expect([pixelAt(half, 5, 3), pixelAt(half, 7, 3)]).toEqual([
      [0, 0, 0, 0],
      [0, 0, 0, 0],
    ]);
    expect(pixelAt(half, 3, 3)[1]).toBe(90);
  });

  test('gl_FragCoord stays that of the pixel, and PASSINDEX is known', async () => {
    const vertex = 'varying float pass;\nvoid main() { isf_vertShaderInit(); if (PASSINDEX == 0) pass = 0.2; else pass = 0.6; }';
    const source = `${header({ PASSES: [{ TARGET: 'a' }, {}] })}varying float pass;
void main() { gl_FragColor = PASSINDEX == 0 ? vec4(pass) : vec4(pass, IMG_THIS_PIXEL(a).r, gl_FragCoord.x / 8.0, 1.0); }`;
    expect(pixelAt(await render(source, { vertex }), 3, 0)).toEqual([153, 51, Math.round((3.5 / 8) * 255), 255]);
  });

  test('that are missing leave zeros, with a warning', async () => {
    const picture = await render(`${header({})}varying vec2 left;\nvoid main() { gl_FragColor = vec4(left, 1.0, 1.0); }`);
    expect(pixelAt(picture, 4, 4)).toEqual([0, 0, 255, 255]);
  });
});

test('an event is true where it happens', async () => {
  const source = `${header({ INPUTS: [{ NAME: 'flash', TYPE: 'event' }] })}void main() { gl_FragColor = flash ? vec4(1.0) : vec4(0.0, 0.0, 0.0, 1.0); }`;
  expect(pixelAt(await render(source, { params: { flash: 0 } }), 0, 0)).toEqual([0, 0, 0, 255]);
  expect(pixelAt(await render(source, { params: { flash: 1 } }), 0, 0)).toEqual([255, 255, 255, 255]);
});

describe('sound', () => {
  const INPUTS = [
    { NAME: 'wave', TYPE: 'audio', MAX: 4 },
    { NAME: 'fft', TYPE: 'audioFFT' },
  ];

  test('is a picture with a row per channel', async () => {
    const wave = paint(4, 2, (x, y) => [x * 60 + (1 - y) * 20, 99, 99, 99]);
    const source = `${header({ INPUTS })}void main() { gl_FragColor = vec4(IMG_NORM_PIXEL(wave, vec2(0.625, 0.75)).r, IMG_PIXEL(wave, vec2(2.5, 0.5)).b, IMG_SIZE(wave).x / 8.0, IMG_NORM_PIXEL(fft, isf_FragNormCoord).a); }`;
    const picture = await render(source, { pictures: { wave: toPage(wave), fft: toPage(wave) } });
    expect(pixelAt(picture, 1, 1)).toEqual([140, 120, 128, 255]);
    expect(linkText(source)[0]?.samplers.map((sampler) => sampler.source)).toEqual([
      { kind: 'sound', input: 'wave', analysis: 'waveform', count: 4 },
      { kind: 'sound', input: 'fft', analysis: 'spectrum', count: 512 },
    ]);
  });

  test('without a wire is silence: the middle of the waveform, and no frequency', async () => {
    const source = `${header({ INPUTS })}void main() { gl_FragColor = vec4(IMG_NORM_PIXEL(wave, vec2(0.5)).rg, IMG_NORM_PIXEL(fft, vec2(0.5)).r, 1.0); }`;
    const picture = await drawPicture(page, { width: 2, height: 2, passes: linkText(source, { absent: ['wave', 'fft'] }) });
    expect(pixelAt(picture, 0, 0)).toEqual([128, 128, 0, 255]);
  });
});

describe('imported pictures', () => {
  test.each([
    ['an object', { leak: { PATH: 'leak.png' } }],
    ['a list', [{ NAME: 'leak', PATH: 'leak.png' }]],
  ])('as %s, with straight alpha and their own size', async (_, IMPORTED) => {
    const leak = paint(2, 1, (x) => (x === 0 ? [255, 0, 0, 255] : [0, 64, 0, 128]));
    const source = `${header({ IMPORTED })}void main() { gl_FragColor = vec4(IMG_NORM_PIXEL(leak, vec2(0.25, 0.5)).r, IMG_PIXEL(leak, vec2(1.5, 0.5)).g, IMG_SIZE(leak).x / 4.0, 1.0); }`;
    expect(pixelAt(await render(source, { pictures: { leak: toPage(leak) } }), 0, 0)).toEqual([255, 128, 128, 255]);
  });

  test('cubes are read by a direction, also by functions that take them', async () => {
    const PATH = ['px.png', 'nx.png', 'py.png', 'ny.png', 'pz.png', 'nz.png'];
    const sides = PATH.map((_, i) => [i * 40, 0, 0, 255]);
    const source = `${header({ IMPORTED: { sky: { TYPE: 'cube', PATH } } })}vec4 look(samplerCube cube, vec3 d) { return textureCube(cube, d); }
void main() { gl_FragColor = vec4(look(sky, vec3(0, -1, 0)).r, texture(sky, vec3(0.0, 0.0, 3.0)).r, IMG_NORM_PIXEL(sky, vec3(-1, 0, 0)).r, 1.0); }`;
    expect(pixelAt(await render(source, { cubes: { sky: sides } }), 0, 0)).toEqual([120, 160, 40, 255]);
  });
});

test('what hosts tell of an image beside its pixels', async () => {
  const source = `${header({ INPUTS: [IMAGE] })}uniform vec2 _inputImage_imgSize;
void main() { gl_FragColor = vec4(_inputImage_imgSize / 16.0, _inputImage_flip ? 1.0 : _inputImage_imgRect.z, 1.0); }`;
  const picture = await render(source, { pictures: { inputImage: toPage(paint(8, 8, () => [0, 0, 0, 255])) } });
  expect(pixelAt(picture, 0, 0)).toEqual([128, 128, 255, 255]);
});
