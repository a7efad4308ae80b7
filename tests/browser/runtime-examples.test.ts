import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import type { Played } from './runtime-examples.page.ts';

const page = useModule('tests/browser/runtime-examples.page.ts', {
  mounts: { '/nodes/': join(process.cwd(), 'nodes') },
});

const CAMERA = [100, 150, 200, 255];

function compileExample(type: string): Program {
  return compileText(readFileSync(`nodes/${type}/example/project.scrim.json`, 'utf8'));
}

function compileText(text: string): Program {
  const { output: project, diagnostics } = loadProject({ project: text, layout: null, sources: {} });
  expect(diagnostics).toEqual([]);
  const compiled = project ? compile({ project, library: LIBRARY }) : null;
  if (!compiled?.output) throw new Error(JSON.stringify(compiled?.diagnostics));
  return compiled.output;
}

async function play(type: string, timeS = 0, roomM = 0): Promise<Played> {
  const played = await page.call<Played>('play', compileExample(type), `nodes/${type}/example/`, timeS, CAMERA, roomM);
  expect({ diagnostics: played.diagnostics, error: played.error }).toEqual({ diagnostics: [], error: 0 });
  return played;
}

/** W3C Filter Effects, `sepia()`, of the camera's color. */
function sepia(amount: number): number[] {
  const [r = 0, g = 0, b = 0] = CAMERA;
  const full = [0.393 * r + 0.769 * g + 0.189 * b, 0.349 * r + 0.686 * g + 0.168 * b, 0.272 * r + 0.534 * g + 0.131 * b];
  return [...full.map((value, i) => Math.min(255, Math.round((CAMERA[i] ?? 0) * (1 - amount) + value * amount))), 255];
}

describe('the example of', () => {
  test('output/screen shows the camera picture', async () => {
    expect((await play('output/screen')).center).toEqual(CAMERA);
  });

  test('source/camera-video shows it in sepia', async () => {
    expect((await play('source/camera-video')).center).toEqual(sepia(1));
  });

  test('source/image-file shows a yellow sticker before it', async () => {
    const { center, corner } = await play('source/image-file');
    expect(center).toEqual([255, 205, 60, 255]);
    expect(corner).toEqual(CAMERA);
  });

  test('source/video-file shows its transparent ball in front, at any moment', async () => {
    for (const timeS of [0, 0.7, 2.3]) {
      const { center, corner } = await play('source/video-file', timeS);
      // Within what the codec leaves of it.
      expect([timeS, center.map((value, i) => Math.abs(value - ([255, 139, 60, 255][i] ?? 0)) <= 8)]).toEqual([
        timeS,
        [true, true, true, true],
      ]);
      expect(corner).toEqual(CAMERA);
    }
  });

  test('source/audio-file shows its tones as bars: the octave above its lowest in the middle, nothing where it has no tone', async () => {
    const { center, corner } = await play('source/audio-file', 0.5);
    expect(center).toEqual([51, 204, 255, 255]);
    expect(corner).toEqual(CAMERA);
  });

  test('source/microphone shows a flat line without permission', async () => {
    const { center, corner } = await play('source/microphone');
    expect(center[0]).toBeGreaterThan(150);
    expect(corner).toEqual(CAMERA);
  });

  test.each(['light/point', 'light/spot'])('%s lights the floor below it, and not far away', async (type) => {
    const { center } = await play(type);
    expect([Math.max(...center.slice(0, 3)) > 60, center]).not.toEqual([false, CAMERA]);
  });

  test.each([
    ['source/panorama', 2 ** 0.5],
    ['light/environment', 1.2],
  ])('%s shows the sky around its object', async (type, brightness) => {
    const { center, corner } = await play(type);
    // Below is the sky's dark ground, as `tools/examples/sky.ts` paints it.
    const ground = [0.05, 0.045, 0.04].map((radiance) => 255 * (1.055 * (radiance * brightness) ** (1 / 2.4) - 0.055));
    expect(corner.slice(0, 3).map((value, i) => Math.abs(value - (ground[i] ?? 0)) <= 2)).toEqual([true, true, true]);
    expect(center).not.toEqual(CAMERA);
  });

  test('layer/object-mask shows the camera’s own colors through a window in the shape of a ball', async () => {
    const { center, corner } = await play('layer/object-mask');
    expect(center).toEqual(CAMERA);
    expect(corner).toEqual(sepia(1));
  });

  test('layer/depth-mask shows what is near in sepia, and what is far or unknown as it is', async () => {
    expect((await play('layer/depth-mask', 0, 0.7)).center).toEqual(sepia(1));
    expect((await play('layer/depth-mask', 0, 3)).center).toEqual(CAMERA);
    expect((await play('layer/depth-mask', 0, 0)).center).toEqual(CAMERA);
  });

  test('objects/apply-technique shows a ball in warm tones where it faces the sun', async () => {
    const { center, corner } = await play('objects/apply-technique');
    expect(corner).toEqual(CAMERA);
    // Gooch's warm tone: what faces the sun and the eye is yellow, which neither the ball nor the camera is.
    expect(center[0]).toBeGreaterThan((center[2] ?? 0) + 20);
  });

  test('value/number sets the strength of a filter', async () => {
    expect((await play('value/number')).center).toEqual(sepia(0.6));
  });

  test('value/math does so with a number worked out', async () => {
    expect((await play('value/math')).center).toEqual(sepia(0.5));
  });

  test('value/expression swings the strength of a filter around a number', async () => {
    expect((await play('value/expression')).center).toEqual(sepia(0.5));
    expect((await play('value/expression', 1)).center).toEqual(sepia(0.75));
    expect((await play('value/expression', 3)).center).toEqual(sepia(0.25));
  });

  test('value/color gives a filter its color', async () => {
    // A picture of one color has no edges: the drawing is all paper.
    expect((await play('value/color')).center).toEqual([0, 0, 0, 255]);
  });

  test('value/time moves the strength of a filter with time', async () => {
    expect((await play('value/time', 1)).center).toEqual(sepia(0.25));
    expect((await play('value/time', 6)).center).toEqual(sepia(0.5));
  });

  test.each(['world/depth', 'layer/depth-occlusion'])('%s shows a thing before the room, and not behind it', async (type) => {
    const before = await play(type, 0, 3);
    expect(before.center).not.toEqual(CAMERA);
    expect(before.corner).toEqual(CAMERA);
    expect((await play(type, 0, 0.5)).center).toEqual(CAMERA);
    // Unknown depth hides nothing.
    expect((await play(type, 0, 0)).center).toEqual(before.center);
  });
});

/** The camera's picture in gray within a region, and as a drawing in the rest. The region is a ball that moves away after a second. */
const REGIONS = JSON.stringify({
  format: 'scrim-project',
  version: 1,
  title: 'Black and white in this region, ink in the rest',
  graphs: {
    main: {
      nodes: {
        'video-a1': { type: 'source/camera-video', version: 1 },
        'grey-b2': { type: 'filter/grey', version: 1 },
        'ink-c3': { type: 'filter/difference-of-gaussians', version: 1, params: { lineColor: [0, 0, 1, 1], paperColor: [0, 1, 0, 1] } },
        'ball-d4': { type: 'objects/primitive', version: 1, params: { shape: 'sphere' } },
        'place-e5': { type: 'objects/transform', version: 1, params: { positionM: { expression: '[time < 1 ? 0 : 9, 0, 0]' } } },
        'region-f6': { type: 'layer/object-mask', version: 1 },
        'choose-g7': { type: 'operator/choose-by-mask', version: 1 },
        'screen-h8': { type: 'output/screen', version: 1 },
      },
      wires: [
        'video-a1.layer -> grey-b2.inputImage',
        'video-a1.layer -> ink-c3.inputImage',
        'ball-d4.objects -> place-e5.objects',
        'place-e5.objects -> region-f6.objects',
        'grey-b2.layer -> choose-g7.inside',
        'ink-c3.layer -> choose-g7.outside',
        'region-f6.layer -> choose-g7.mask',
        'choose-g7.layer -> screen-h8.layer',
      ],
    },
  },
});

test('black and white in this region and ink in the rest is three wires, and the region may move', async () => {
  expect(REGIONS.match(/-> choose-g7/g)).toHaveLength(3);
  const playRegions = async (timeS: number): Promise<Played> => {
    const played = await page.call<Played>('play', compileText(REGIONS), 'nodes/', timeS, CAMERA, 0);
    expect({ diagnostics: played.diagnostics, error: played.error }).toEqual({ diagnostics: [], error: 0 });
    return played;
  };
  const first = await playRegions(0);
  const gray = Math.round(0.2126 * 100 + 0.7152 * 150 + 0.0722 * 200);
  expect(first.center.map((value, i) => Math.abs(value - ([gray, gray, gray, 255][i] ?? 0)) <= 1)).toEqual([true, true, true, true]);
  const later = await playRegions(1);
  expect(later.center).toEqual(later.corner);
  expect(first.corner).toEqual(later.corner);
  // A picture of one color has no lines: it is paper, or as dark as its tone.
  expect(first.corner).not.toEqual(first.center);
});
