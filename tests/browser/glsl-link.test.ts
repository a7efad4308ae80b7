import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import type { DrawJob } from './glsl.page.ts';
import { drawFloats, drawPicture, linkText, PAGE, paint, toPage } from './glsl-kit.ts';

const page = useModule(PAGE);

function header(fields: Readonly<Record<string, unknown>>): string {
  return `/*${JSON.stringify({ ISFVSN: '2', ...fields })}*/\n`;
}

const IMAGE = { NAME: 'inputImage', TYPE: 'image' };

/** What a file makes of an image of 8 by 8 pixels, unless `job` says otherwise. */
function render(source: string, job: Partial<DrawJob> = {}): Promise<RgbaImage> {
  return drawPicture(page, { width: 8, height: 8, ...job, passes: job.passes ?? linkText(source) });
}

describe('images', () => {
  const squares = paint(8, 8, (x, y) => [x * 30, y * 30, 0, 255]);
  const pictures = { inputImage: toPage(squares) };

  test('every way of reading this pixel is the same', async () => {
    for (const read of [
      'IMG_THIS_PIXEL(inputImage)',
      'IMG_THIS_NORM_PIXEL(inputImage)',
      'IMG_NORM_PIXEL(inputImage, isf_FragNormCoord)',
      'IMG_NORM_PIXEL(inputImage, vv_FragNormCoord.xy)',
      'IMG_PIXEL(inputImage, gl_FragCoord.xy)',
      'IMG_PIXEL(inputImage, isf_FragNormCoord * IMG_SIZE(inputImage))',
      'texture2D(inputImage, gl_FragCoord.xy / RENDERSIZE)',
      'texture(inputImage, isf_FragNormCoord)',
      'texture2DProj(inputImage, vec3(isf_FragNormCoord * 2.0, 2.0))',
      'texture2DLodEXT(inputImage, isf_FragNormCoord, 0.0)',
      'texelFetch(inputImage, ivec2(gl_FragCoord.xy), 0)',
      'textureOffset(inputImage, isf_FragNormCoord - vec2(1.0, 0.0) / 8.0, ivec2(1, 0))',
      'both(inputImage, isf_FragNormCoord)',
    ]) {
      const source = `${header({ INPUTS: [IMAGE] })}vec4 one(sampler2D image, vec2 uv) { return IMG_NORM_PIXEL(image, uv); }\nvec4 both(sampler2D image, vec2 uv) { return one(image, uv) * 0.5 + texture2D(image, uv) * 0.5; }\nvoid main() { gl_FragColor = ${read}; }`;
      expect({ read, pixels: await render(source, { pictures }) }).toEqual({ read, pixels: squares });
    }
  });

  test('a function serves several images', async () => {
    const other = { NAME: 'other', TYPE: 'image' };
    const source = `${header({ INPUTS: [IMAGE, other] })}vec4 at(sampler2D image) { return IMG_THIS_PIXEL(image); }\nvoid main() { gl_FragColor = vec4(at(inputImage).r, at(other).g, 0.0, 1.0); }`;
    const flat = paint(8, 8, () => [0, 77, 0, 255]);
    const picture = await render(source, { pictures: { ...pictures, other: toPage(flat) } });
    expect(pixelAt(picture, 2, 5)).toEqual([60, 77, 0, 255]);
  });

  test('beyond the edge is the nearest pixel', async () => {
    const shifted = await render(
      `${header({ INPUTS: [IMAGE] })}void main() { gl_FragColor = IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(6.0, 0.0)); }`,
      { pictures },
    );
    expect(pixelAt(shifted, 0, 3)).toEqual([180, 90, 0, 255]);
    expect(pixelAt(shifted, 7, 3)).toEqual([210, 90, 0, 255]);
  });

  test('authors see straight alpha, and what they write is premultiplied', async () => {
    const half = paint(8, 8, () => [64, 0, 0, 128]);
    const straight = await render(
      `${header({ INPUTS: [IMAGE] })}void main() { vec4 c = IMG_THIS_PIXEL(inputImage); gl_FragColor = vec4(c.r, c.a, 0.0, 1.0); }`,
      {
        pictures: { inputImage: toPage(half) },
      },
    );
    expect(pixelAt(straight, 1, 1)).toEqual([128, 128, 0, 255]);
    const written = await render(`${header({})}void main() { gl_FragColor = vec4(2.0, 0.5, 0.0, 0.5); }`);
    // Red is clamped before alpha is multiplied in.
    expect(pixelAt(written, 1, 1)).toEqual([128, 64, 0, 128]);
    const asStored = await render(
      `${header({ INPUTS: [IMAGE], SCRIM_ALPHA: 'premultiplied' })}void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }`,
      {
        pictures: { inputImage: toPage(half) },
      },
    );
    expect(pixelAt(asStored, 1, 1)).toEqual([64, 0, 0, 128]);
  });

  test('every premultiplied color of 8 bits comes through a filter that changes nothing', async () => {
    const all = paint(256, 256, (x, y) => [Math.min(x, y), Math.floor(Math.min(x, y) / 2), y, y]);
    const source = `${header({ INPUTS: [IMAGE] })}void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }`;
    expect(await render(source, { width: 256, height: 256, pictures: { inputImage: toPage(all) } })).toEqual(all);
  });

  test('a turned and cropped camera picture is laid on the view', async () => {
    // Texture (u, v) = (1 - view v, 0.25 + view u / 2): a quarter turn of the middle half.
    const uvFromViewUv = [0, 0.5, 0, -1, 0, 0, 1, 0.25, 1];
    const picture = await render(`${header({ INPUTS: [IMAGE] })}void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }`, {
      width: 4,
      height: 8,
      pictures: { inputImage: { ...toPage(squares), uvFromViewUv } },
    });
    // The view's bottom left pixel center is (1/8, 1/16): texture (15/16, 5/16), pixel 7 from the left, 2 from the bottom.
    expect(pixelAt(picture, 0, 7)).toEqual([210, 150, 0, 255]);
  });

  test('beside a picture that is fitted in there is nothing', async () => {
    // Twice as wide as the image: the view shows texture u from -0.5 to 1.5.
    const uvFromViewUv = [2, 0, 0, 0, 1, 0, -0.5, 0, 1];
    const picture = await render(`${header({ INPUTS: [IMAGE] })}void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }`, {
      width: 16,
      height: 8,
      pictures: { inputImage: { ...toPage(squares), uvFromViewUv } },
    });
    expect(pixelAt(picture, 3, 4)).toEqual([0, 0, 0, 0]);
    expect(pixelAt(picture, 4, 4)).toEqual([0, 120, 0, 255]);
    expect(pixelAt(picture, 11, 4)).toEqual([210, 120, 0, 255]);
    expect(pixelAt(picture, 12, 4)).toEqual([0, 0, 0, 0]);
  });

  test('an optional image that is not wired is transparent', async () => {
    const source = `${header({ INPUTS: [{ ...IMAGE, OPTIONAL: true }] })}void main() { vec4 c = IMG_THIS_PIXEL(inputImage); gl_FragColor = vec4(c.a, IMG_SIZE(inputImage).x > 0.0, 1.0, 1.0); }`;
    const passes = linkText(source, { absent: ['inputImage'] });
    expect(passes[0]?.samplers).toEqual([]);
    expect(pixelAt(await render(source, { passes }), 1, 1)).toEqual([0, 255, 255, 255]);
  });

  test('layer and room depth come in meters, for Scrim alone', async () => {
    const source = `${header({ INPUTS: [IMAGE, { NAME: 'room', TYPE: 'depth' }] })}
void main() {
  gl_FragColor = vec4(1.0);
#ifdef SCRIM
  gl_FragColor = vec4(LAYER_DEPTH(inputImage, isf_FragNormCoord) / 8.0, ROOM_DEPTH(room, isf_FragNormCoord) / 8.0, 0.0, 1.0);
#endif
}`;
    const [p10, p14] = [-1.004, -0.2004];
    const picture = await render(source, {
      width: 2,
      height: 1,
      pictures,
      depths: {
        // What a depth buffer holds for 3 m, and where nothing was drawn.
        inputImage: { width: 2, height: 1, values: [0.5 * (-p10 + p14 / 3) + 0.5, 1], decode: [p10, p14, 0, 1] },
        room: { width: 2, height: 1, values: [5, 0] },
      },
    });
    expect(pixelAt(picture, 0, 0)).toEqual([96, 159, 0, 255]);
    expect(pixelAt(picture, 1, 0)).toEqual([0, 0, 0, 255]);
  });
});

describe('discard', () => {
  test('makes the pixel transparent, from whatever function', async () => {
    const source = `${header({})}
struct Hit { float t; vec3 p; };
Hit trace(float x) { if (x < 3.0) discard; return Hit(x, vec3(1.0)); }
float deeper(float x) { return trace(x).t; }
void main() { float t = deeper(gl_FragCoord.x); gl_FragColor = vec4(1.0); if (t > 6.0) { discard; } }`;
    const row = await render(source, { width: 8, height: 1 });
    expect([...row.data].filter((_, i) => i % 4 === 3)).toEqual([0, 0, 0, 255, 255, 255, 0, 0]);
  });
});

describe('passes', () => {
  test('a buffer has the size of its expression and RENDERSIZE tells it', async () => {
    const source = `${header({
      INPUTS: [{ NAME: 'part', TYPE: 'float' }],
      PASSES: [{ TARGET: 'small', WIDTH: 'floor($WIDTH * $part)', HEIGHT: 'max(2, $HEIGHT / 8.0)' }, {}],
    })}
void main() {
  if (PASSINDEX == 0) gl_FragColor = vec4(RENDERSIZE / 16.0, gl_FragCoord.xy / 16.0);
  else gl_FragColor = vec4(IMG_PIXEL(small, vec2(0.5)).xy, IMG_SIZE(small).x / 16.0, 1.0);
}`;
    const picture = await render(source, { width: 16, height: 8, params: { part: 0.3 } });
    expect(pixelAt(picture, 9, 4)).toEqual([64, 32, 64, 255]);
  });

  test('a persistent counter counts, in floats beyond 1', async () => {
    const source = `${header({ PASSES: [{ TARGET: 'count', PERSISTENT: true, FLOAT: true, WIDTH: 1, HEIGHT: 1 }, {}] })}
void main() {
  vec4 before = IMG_NORM_PIXEL(count, vec2(0.5));
  if (PASSINDEX == 0) gl_FragColor = before + vec4(1.0, 0.001, 0.0, 0.0);
  else gl_FragColor = vec4(before.x / 100.0, before.y * 10.0, 0.0, 1.0);
}`;
    expect(pixelAt(await render(source, { frames: 25 }), 0, 0)).toEqual([64, 64, 0, 255]);
  });

  test('a feedback on the last pass decays as computed by hand', async () => {
    const source = `${header({ PASSES: [{ TARGET: 'trail', PERSISTENT: true }] })}
void main() { gl_FragColor = FRAMEINDEX == 0 ? vec4(1.0) : IMG_THIS_PIXEL(trail) * 0.5; }`;
    const passes = linkText(source);
    expect(passes.map((pass) => pass.target.kind)).toEqual(['buffer', 'output']);
    const picture = await render(source, { frames: 3 });
    // 255 → 127.5 → 128 → 64, and the layer is the buffer, premultiplied: 64 * 64 / 255 = 16.
    expect(pixelAt(picture, 4, 4)).toEqual([16, 16, 16, 64]);
  });

  test('version 1 buffers persist too', async () => {
    const source = `/*{ "PERSISTENT_BUFFERS": ["memory"], "PASSES": [{ "TARGET": "memory" }, {}] }*/
void main() { vec4 m = IMG_THIS_PIXEL(memory); gl_FragColor = PASSINDEX == 0 ? m + vec4(0.1, 0.0, 0.0, 1.0) : vec4(m.rgb, 1.0); }`;
    expect(pixelAt(await render(source, { frames: 4 }), 4, 4)[0]).toBeCloseTo(102, -1);
  });

  test('a buffer drawn twice in a frame is read as the pass before left it', async () => {
    const source = `${header({ PASSES: [{ TARGET: 'b' }, { TARGET: 'b' }, {}] })}
void main() { gl_FragColor = IMG_THIS_PIXEL(b) + vec4(0.2, 0.0, 0.0, 1.0); }`;
    const passes = linkText(source);
    // Nothing is read of a buffer before it is drawn, and no pass reads what it draws into.
    expect(passes.map((pass) => pass.samplers.map((s) => s.source))).toEqual([
      [],
      [{ kind: 'buffer', target: 'b' }],
      [{ kind: 'buffer', target: 'b#1' }],
    ]);
    expect(pixelAt(await render(source), 4, 4)).toEqual([153, 0, 0, 255]);
  });

  test('each pass reads only what it can get to', () => {
    const passes = linkText(`${header({ INPUTS: [IMAGE], PASSES: [{ TARGET: 'first' }, { TARGET: 'second' }, {}] })}
vec4 pick() {
  if (PASSINDEX == 0) return IMG_THIS_PIXEL(inputImage);
  return PASSINDEX == 1 ? IMG_THIS_PIXEL(first) : IMG_THIS_PIXEL(second);
}
void main() { gl_FragColor = pick(); }`);
    expect(passes.map((pass) => pass.samplers.map((sampler) => sampler.name))).toEqual([['a_inputImage'], ['a_first'], ['a_second']]);
  });

  test('automatic variables', async () => {
    const source = `${header({})}void main() {
  vec4 c = vec4(TIME * 6.0, TIMEDELTA * 30.0, float(FRAMEINDEX) / 10.0, 1.0);
  gl_FragColor = gl_FragCoord.x < 1.0 ? c : vec4(DATE.x / 4052.0, DATE.w / 10.0, gl_FragCoord.y / 8.0, 1.0);
}`;
    const picture = await render(source, { frames: 6 });
    expect(pixelAt(picture, 0, 0)).toEqual([128, 128, 128, 255]);
    expect(pixelAt(picture, 1, 0)).toEqual([128, 128, 239, 255]);
  });
});

describe('the loop budget', () => {
  const endless = `${header({})}void main() {
  int i = 0;
  while (i >= 0) { for (;;) { i = (i + 1) % 7; if (i > 9) break; } }
  do { i++; } while (i < 1000000000 || i > 0);
  while (bool again = i != 0) i = again ? 1 : 1;
  gl_FragColor = vec4(0.0, 1.0, 0.0, 1.0);
}`;
  const brief = `${header({ INPUTS: [{ NAME: 'n', TYPE: 'long' }] })}void main() {
  float s = 0.0;
  for (int i = 0; i < n; i++) { if (i == 3) continue; s += 0.1; }
  gl_FragColor = vec4(s, 0.0, 0.0, 1.0);
}`;

  /** Of both: the header's line, the function's, a statement's, the loop's. */
  const LOOP_LINE = 4;

  test('ends endless loops, draws on, and tells the probe which loop it was', async () => {
    const passes = linkText(endless, { loopBudget: true });
    const job = { width: 8, height: 8, passes };
    expect(pixelAt(await drawPicture(page, job), 4, 4)).toEqual([0, 255, 0, 255]);
    expect(await page.call('endlessLine', job, 500)).toBe(LOOP_LINE);
  });

  test('leaves loops that end as they are', async () => {
    const params = { n: 6 };
    const withBudget = await render(brief, { passes: linkText(brief, { loopBudget: true }), params });
    expect(withBudget).toEqual(await render(brief, { params }));
    expect(pixelAt(withBudget, 4, 4)[0]).toBe(128);
    const job = { width: 8, height: 8, passes: linkText(brief, { loopBudget: true }), params };
    expect(await page.call('endlessLine', job, 6)).toBe(LOOP_LINE);
    expect(await page.call('endlessLine', job, 7)).toBeNull();
  });

  test('the vertex shader draws nothing where a probe found too many rounds, or nowhere else', async () => {
    const job = { width: 8, height: 8, passes: linkText(brief, { loopBudget: true }), params: { n: 6 } };
    expect(await page.call('drawBehindGate', job)).toEqual({
      free: [true, true],
      unlessExceeded: [true, false],
      ifExceeded: [false, true],
    });
  });

  test('is not in the text of what has no loops, nor of an export', () => {
    expect(linkText(brief)[0]?.shader.fragment).not.toContain('scrim_spend');
    expect(linkText(`${header({})}void main() { gl_FragColor = vec4(1.0); }`, { loopBudget: true })[0]?.shader.fragment).not.toContain(
      'scrim_spend',
    );
  });
});

test('float outputs are neither clamped nor rounded', async () => {
  const passes = linkText(`${header({ PASSES: [{ FLOAT: true }] })}void main() { gl_FragColor = vec4(3.5, 0.0, 0.0, 1.0); }`);
  expect(passes[0]?.target).toEqual({ kind: 'output', format: 'rgba16f' });
  expect((await drawFloats(page, { width: 1, height: 1, passes }))[0]).toBe(3.5);
});
