import { expect, test } from '@jest/globals';
import { convertShadertoy } from '../../export/glsl/shadertoy/convert-shadertoy.ts';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { drawPicture, linkText, made, PAGE, paint, toPage } from './glsl-kit.ts';

const page = useModule(PAGE);

interface Scene {
  readonly frames?: number;
  readonly picture?: RgbaImage;
  readonly mouse?: readonly [number, number];
}

/** What the real driver draws of a converted source, 16 by 8 pixels. */
function draw(source: string, { frames = 1, picture, mouse = [0, 0] }: Scene = {}): Promise<RgbaImage> {
  const { text } = made(convertShadertoy(source, 'pasted.glsl'));
  return drawPicture(page, {
    width: 16,
    height: 8,
    passes: linkText(text),
    params: { mouse },
    frames,
    ...(picture === undefined ? {} : { pictures: { inputImage: toPage(picture) } }),
  });
}

/** The upper left pixel as 8-bit numbers, unless another is named. */
async function pixel(source: string, scene: Scene = {}, x = 0, y = 0): Promise<readonly number[]> {
  return [...pixelAt(await draw(source, scene), x, y)];
}

const image = (color: string) => `void mainImage(out vec4 fragColor, in vec2 fragCoord) { fragColor = ${color}; }`;

test('fragCoord counts pixels from their centers at the bottom left, and the picture is opaque', async () => {
  const source = image('vec4(fragCoord / 32.0, iResolution.z, 0.25)');
  expect(await pixel(source, {}, 0, 7)).toEqual([4, 4, 255, 255]);
  expect(await pixel(source, {}, 15, 0)).toEqual([124, 60, 255, 255]);
});

test('time, frames and the date count as on the site', async () => {
  // Five frames of 1/60 s; on 4 March, which is month 2 there.
  const source = image(
    'vec4(iTime * 3.0, float(iFrame) / 51.0, (iDate.y + iDate.z) / 51.0, 1.0) * step(0.5, abs(iFrameRate - 60.0) < 0.1 ? 1.0 : 0.0)',
  );
  expect(await pixel(source, { frames: 5 })).toEqual([51, 20, 30, 255]);
});

test('the pointer is where it is pressed, in pixels', async () => {
  expect(await pixel(image('vec4(iMouse.xy / 32.0, iMouse.z > 0.0 ? 1.0 : 0.0, 1.0)'), { mouse: [0.5, 0.25] })).toEqual([64, 16, 255, 255]);
  expect(await pixel(image('vec4(iMouse.z > 0.0 ? 1.0 : 0.0)'))).toEqual([0, 0, 0, 255]);
});

test('a picture repeats, is fetched by whole pixels, and knows its size', async () => {
  const picture = paint(16, 8, (x, y) => [x * 16, y * 32, 0, 255]);
  const twice = image('texture(iChannel0, fragCoord / iResolution.xy + 1.0)');
  expect(await pixel(twice, { picture }, 3, 2)).toEqual([48, 64, 0, 255]);
  const fetched = image('texelFetch(iChannel0, ivec2(5, 1), 0) + vec4(0.0, 0.0, iChannelResolution[0].x / 32.0, 0.0)');
  expect(await pixel(fetched, { picture })).toEqual([80, 192, 128, 255]);
});

/** A counts frames in 64ths, B takes half of this frame's A, and A adds nothing of the B that comes after it. */
const BUFFERS = `// Common
#define LAST(p) texelFetch(iChannel0, ivec2(p), 0)
float keep(float x) { return x; }

// Buffer A
// iChannel0: Buffer A
// iChannel1: Buffer B
float turn(float x) { return x + 1.0 / 64.0; }
void mainImage(out vec4 o, in vec2 p) {
  o = LAST(p);
  o.y = texelFetch(iChannel1, ivec2(p), 0).x;
  o.x = iFrame == 0 ? 0.0 : turn(keep(o.x));
}

// Buffer B
// iChannel0: Buffer A
#define FACTOR 0.5
float turn(float x) { return x * FACTOR; }
void mainImage(out vec4 o, in vec2 p) { o = LAST(p); o.x = turn(o.x); }

// Image
// iChannel0: Buffer B
// iChannel1: Buffer A
#define FACTOR 1.0
float turn(float x) { return x * FACTOR; }
void mainImage(out vec4 o, vec2 p) { o = turn(1.0) * vec4(LAST(p).x, texture(iChannel1, p / iResolution.xy).xy, 0.0); }
`;

test('buffers read earlier buffers of this frame, and later ones of the previous frame', async () => {
  // Frame 32: A = 32/64, B = 16/64, and A saw the B of frame 31.
  expect(await pixel(BUFFERS, { frames: 33 })).toEqual([64, 128, Math.round((31 / 128) * 255), 255]);
});

test('a buffer holds numbers below 1/256', async () => {
  const source = `// Buffer A
// iChannel0: self
void mainImage(out vec4 o, vec2 p) { o = texelFetch(iChannel0, ivec2(p), 0) + 0.001; }
// Image
// iChannel0: Buffer A
void mainImage(out vec4 o, vec2 p) { o = texelFetch(iChannel0, ivec2(p), 0) * 100.0; }`;
  expect((await pixel(source, { frames: 4 }))[0]).toBeCloseTo(0.4 * 255, -0.5);
});

test('tabs that declare the same names as Common and each other are told apart', async () => {
  const source = `// Common
float mixed(float x) { return x; }
struct Ray { vec3 mixed; };
// Buffer A
float mixed(vec2 x) { Ray r = Ray(vec3(mixed(x.x))); return r.mixed.x; }
void mainImage(out vec4 o, vec2 p) { o = vec4(mixed(vec2(0.25, 0.75))); }
// Image
// iChannel0: Buffer A
float mixed(vec2 x) { return mixed(x.y); }
void mainImage(out vec4 o, vec2 p) { o = vec4(mixed(vec2(0.25, 0.75)), texture(iChannel0, vec2(0.5)).x, 0.0, 1.0); }`;
  expect(await pixel(source)).toEqual([191, 64, 0, 255]);
});
