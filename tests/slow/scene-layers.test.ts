import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import { projectText } from '../support/project-kit.ts';
import type { Shot } from './scene-layers.page.ts';

const SIDE = 64;

const page = useModule('tests/slow/scene-layers.page.ts');

type Nodes = Parameters<typeof projectText>[0]['nodes'];

function programOf(nodes: Nodes, wires: readonly string[], source = ''): Program {
  const assets = { sky: { path: 'sky.hdr', kind: 'environment' } } as const;
  const project = projectText({ nodes, wires, assets });
  const loaded = loadProject({ project, layout: null, sources: source === '' ? {} : { 'colors.fs': source } });
  const compiled = loaded.output && compile({ project: loaded.output, library: LIBRARY });
  if (!compiled?.output) throw new Error(JSON.stringify([loaded.diagnostics, compiled?.diagnostics]));
  return compiled.output;
}

async function shoot(programs: readonly Program[], asset: readonly number[] = [], withoutFloats = false): Promise<Shot[]> {
  return await page.call<Shot[]>('shoot', programs, asset, withoutFloats);
}

const generator = (body: string): string => `/*{ "ISFVSN": "2", "SCRIM_ENCODING": "scene", "INPUTS": [] }*/
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ${body}
}`;

/** The colors of a generator through a Tone map. */
const toneMapped = (curve: number, body: string, blurPx = 0): Program =>
  programOf(
    {
      'colors-0000': 'generator/colors',
      'blur-0000': ['filter/gaussian-blur', { radius: blurPx }],
      'map-0000': ['filter/tone-map', { curve }],
      'screen-0000': 'output/screen',
    },
    ['colors-0000.layer -> blur-0000.inputImage', 'blur-0000.layer -> map-0000.inputImage', 'map-0000.layer -> screen-0000.layer'],
    generator(body),
  );

const CLIP = 4;

describe('Tone map', () => {
  /** From 12 stops below 1 to 8 above it along x, of 64 hues along y. */
  const COLORS = `float light = exp2(float(at.x) / 64.0 * 20.0 - 12.0);
  gl_FragColor = vec4(light * vec3(1.0, float(at.y % 8) / 7.0, float(at.y / 8) / 7.0), 1.0);`;
  const colors = Array.from({ length: SIDE * SIDE }, (_, i) => {
    const [x, y] = [i % SIDE, Math.floor(i / SIDE)];
    const light = 2 ** ((x / 64) * 20 - 12);
    return [light, (light * (y % 8)) / 7, (light * Math.floor(y / 8)) / 7, 1];
  }).flat();

  test('gives the pictures of three’s own AgX, Khronos Neutral and ACES', async () => {
    const theirs = await page.call<number[][]>('threesToneMapping', colors, SIDE, SIDE);
    const ours = await shoot([0, 1, 2].map((curve) => toneMapped(curve, COLORS)));
    expect(ours.map(({ told }) => told)).toEqual([[], [], []]);
    const largest = ours.map(({ pixels }, i) =>
      pixels.reduce((most, value, at) => Math.max(most, Math.abs(value - (theirs[i]?.[at] ?? 0))), 0),
    );
    console.info(`Largest differences: ${largest.join(', ')} of 255`);
    for (const difference of largest) expect(difference).toBeLessThanOrEqual(1);
    // Three curves, and not one.
    expect(new Set(ours.map(({ pixels }) => pixels.join())).size).toBe(3);
  });
});

describe('a scene layer', () => {
  test('contains no NaN, which a blur would spread, and infinity is its largest number', async () => {
    const [clean, stray] = await shoot([
      toneMapped(CLIP, 'gl_FragColor = vec4(0.2, 0.2, 0.2, 1.0);', 4),
      toneMapped(
        CLIP,
        `float zero = TIME * 0.0;
  gl_FragColor = vec4(0.2, 0.2, 0.2, 1.0);
  if (at == ivec2(20)) gl_FragColor = vec4(zero / zero, 1.0 / zero, 0.2, 1.0);`,
        4,
      ),
    ]);
    const at = (shot: Shot | undefined, x: number, y: number): number[] =>
      (shot?.pixels ?? []).slice((y * SIDE + x) * 4, (y * SIDE + x) * 4 + 4);
    expect(at(stray, 50, 50)).toEqual(at(clean, 50, 50));
    const [red = 0, green = 0, blue = 0, alpha = 0] = at(stray, 21, 21);
    const [gray = 0] = at(clean, 21, 21);
    // NaN is 0, so there is a little less red around it.
    expect([red > gray - 8, red <= gray, green, blue, alpha]).toEqual([true, true, 255, gray, 255]);
  });

  test('stays free of it where objects have colors that are no numbers', async () => {
    expect(await page.call('strayNumbers')).toEqual({
      notFinite: 0,
      largest: 65504,
      pixels: [
        [0, 65504, 2, 1],
        [0.5, -65504, 65504, 0],
      ],
    });
  });

  /** 8 × 4 pixels of a Radiance file, each a gray from 0.02 to 0.9. */
  const panorama = (): number[] => {
    const head = [...Buffer.from('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n')];
    const pixels = Array.from({ length: 32 }, (_, i) => {
      const gray = 0.02 + (0.88 * i) / 31;
      const exponent = Math.ceil(Math.log2(gray));
      return [...new Array<number>(3).fill(Math.floor((gray / 2 ** exponent) * 255.9)), exponent + 128];
    });
    return [...head, ...pixels.flat()];
  };

  const underSky = (encoding: 'display' | 'scene', stops: number): Program => {
    const map: Nodes = encoding === 'scene' ? { 'map-0000': ['filter/tone-map', { curve: CLIP }] } : {};
    const last = encoding === 'scene' ? 'map-0000' : 'expose-0000';
    return programOf(
      {
        'sky-0000': ['source/panorama', { file: 'sky', exposure: stops }],
        'light-0000': ['light/environment', { visible: true }],
        'ball-0000': ['objects/primitive', { shape: 'sphere', sizeM: [0.8, 0.8, 0.8] }],
        'scene-0000': ['layer/scene', { encoding }],
        'expose-0000': ['filter/hdr-exposure', { stops: -stops }],
        ...map,
        // Edges are smoothed in linear light in one and in sRGB in the other.
        'screen-0000': ['output/screen', { antialias: false }],
      },
      [
        'sky-0000.environment -> light-0000.environment',
        'light-0000.lights -> scene-0000.lights',
        'ball-0000.objects -> scene-0000.objects',
        'scene-0000.layer -> expose-0000.inputImage',
        ...(encoding === 'scene' ? ['expose-0000.layer -> map-0000.inputImage'] : []),
        `${last}.layer -> screen-0000.layer`,
      ],
    );
  };

  const apart = (a: Shot | undefined, b: Shot | undefined): number =>
    (a?.pixels ?? []).reduce((most, value, i) => Math.max(most, Math.abs(value - (b?.pixels[i] ?? 0))), 0);

  test('keeps what is too bright, so an exposure brings back the sky and the objects in it', async () => {
    const [right, scene, display] = await shoot([underSky('display', 0), underSky('scene', 4), underSky('display', 4)], panorama());
    expect(new Set(right?.pixels.filter((_, i) => i % 4 === 0)).size).toBeGreaterThan(40);
    expect(apart(scene, right)).toBeLessThanOrEqual(2);
    // A display layer has clipped it to white, which is then 4 stops darker.
    expect(apart(display, right)).toBeGreaterThan(100);
  });

  test('is a display layer where the GPU draws no floats, and the player says so', async () => {
    const program = toneMapped(CLIP, 'gl_FragColor = vec4(vec3(at.x, at.y, at.x + at.y) / 64.0, 1.0);');
    const [floats] = await shoot([program]);
    const [bytes] = await shoot([program], [], true);
    expect([floats?.told, bytes?.told]).toEqual([[], ['SCR055']]);
    expect(apart(floats, bytes)).toBeLessThanOrEqual(2);
  });
});
