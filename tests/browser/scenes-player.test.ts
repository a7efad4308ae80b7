import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { LIBRARY } from '../support/library.ts';
import type { Example } from './scenes-player.page.ts';

const page = useModule('tests/browser/scenes-player.page.ts', { mounts: { '/nodes/': resolve('nodes') } });

test('a scene and its shadow are played as layers, follow their params, and leave nothing behind', async () => {
  // 0.8 of white light from 45 degrees on red: 0.8 × cos 45° = 0.566, encoded 198. All colors mirror a little light.
  const sheen = expect.closeTo(24, -1);
  const first = { boxTop: [expect.closeTo(198, -1), sheen, sheen, 255], shadow: [0, 0, 0, 255], floor: [0, 255, 0, 255] };
  expect(await page.call('plays')).toEqual({
    first,
    changed: { boxTop: [sheen, sheen, sheen, 255], shadow: [0, 255, 0, 255], floor: [0, 255, 0, 255] },
    replaced: first,
    same: true,
    diagnostics: [],
    alive: {},
    error: 0,
  });
});

test('two lights on wires of their own both throw shadows, each half as dark', async () => {
  const half = expect.closeTo(128, -1);
  expect(await page.call('twoLights')).toEqual({ right: half, left: half, front: 255 });
});

test('a broken model is told at its node', async () => {
  expect(await page.call('brokenModel')).toEqual([
    expect.objectContaining({
      code: 'SCR032',
      nodeId: 'fox',
      message: 'The model "assets/fox.glb" cannot be decoded: the file is incomplete: it has 8 of 20 bytes. Copy or export it again.',
    }),
  ]);
});

test.each([
  ['a hard border', { biasM: 0, softnessM: 0 }, {}],
  ['a soft border', { biasM: 0.01, softnessM: 0.4 }, {}],
  ['a border some pixels wide', { borderPx: 5 }, {}],
  ['the nearest samples, holes and all', {}, { filter: 'nearest', fillHoles: false }],
  ['tolerance, blended samples and holes', { biasM: 0.15 }, { filter: 'linear', fillHoles: false }],
  ['edges as the camera sees them', { softnessM: 0.1 }, { filter: 'edge-aware', smoothingS: 0.3 }],
])('with %s, hiding fragments gives the picture of hiding the finished layer, in both eyes', async (_what, params, roomParams) => {
  const found = await page.call<{ pixels: number; apart: number; covered: number; errors: number[] }>('equalForms', params, roomParams);
  const { pixels, apart, covered, errors } = found;
  expect(errors).toEqual([0, 0]);
  expect(covered).toBeGreaterThan(2000);
  // A border that passes exactly through a pixel's middle may round apart; a wide one looks at 16 places for each.
  expect(apart).toBeLessThanOrEqual(3);
  expect(pixels).toBeLessThanOrEqual('borderPx' in params ? 16 : 3);
});

function compileExample(type: string): Program {
  const text = readFileSync(`nodes/${type}/example/project.scrim.json`, 'utf8');
  const { output: project } = loadProject({ project: text, layout: null, sources: {} });
  const { output, diagnostics } = project ? compile({ project, library: LIBRARY }) : { output: null, diagnostics: [] };
  if (!output) throw new Error(JSON.stringify(diagnostics));
  return output;
}

const TYPES = [
  'source/model',
  'objects/primitive',
  'objects/transform',
  'objects/group',
  'objects/phantom',
  'light/directional',
  'layer/scene',
  'layer/shadow',
];

test('the examples of the object nodes compile, play and are seen', async () => {
  const examples = TYPES.map((type): Example => ({ program: compileExample(type), assetUrl: `/nodes/${type}/example/` }));
  const seen = await page.call<{ covered: number; colors: number; diagnostics: unknown[]; error: number }[]>('playExamples', examples);
  for (const [i, type] of TYPES.entries()) {
    expect([type, seen[i]]).toEqual([type, { covered: expect.any(Number), colors: expect.any(Number), diagnostics: [], error: 0 }]);
    expect([type, (seen[i]?.covered ?? 0) > 50, (seen[i]?.colors ?? 0) > 3]).toEqual([type, true, true]);
  }
});
