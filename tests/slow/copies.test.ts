import { expect, test } from '@jest/globals';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { compileText } from '../support/compile-project.ts';
import { type ProjectText, projectText } from '../support/project-kit.ts';
import type { Played } from './copies.page.ts';

const page = useModule('tests/slow/copies.page.ts');

const COUNT = 8;
const STEP = [0.2, 0, -0.15] as const;
const SIZE = [0.12, 0.3, 0.12];

/** Cones in a row on a real floor, by one node of copies or by a Transform for each. */
function programOf(by: 'copies' | 'transforms'): Program {
  const places = Array.from({ length: by === 'copies' ? 1 : COUNT }, (_, i) => i);
  const nodes: Record<string, ProjectText['nodes'][string]> = {
    'cone-0000': ['objects/primitive', { shape: 'cone', sizeM: SIZE, color: [0.8, 0.4, 0.2, 1] }],
    'floor-0000': ['objects/primitive', { shape: 'plane', sizeM: [4, 0, 4] }],
    'real-0000': 'objects/phantom',
    'sun-0000': ['light/directional', { azimuthRad: -1, elevationRad: 0.8, areaM: 4 }],
    'scene-0000': 'layer/scene',
    'shadow-0000': 'layer/shadow',
    'over-0000': 'operator/over',
    'screen-0000': ['output/screen', { antialias: false }],
  };
  const wires = [
    'floor-0000.objects -> real-0000.objects',
    'real-0000.objects -> shadow-0000.receivers',
    'sun-0000.lights -> scene-0000.lights',
    'sun-0000.lights -> shadow-0000.lights',
    'scene-0000.layer -> over-0000.top',
    'shadow-0000.layer -> over-0000.bottom',
    'over-0000.layer -> screen-0000.layer',
  ];
  for (const i of places) {
    const place = `place-${String(i).padStart(4, '0')}`;
    const [x, , z] = STEP;
    nodes[place] = ['objects/transform', { positionM: [-0.5 + i * x, 0.15, 0.3 + i * z] }];
    wires.push(`cone-0000.objects -> ${place}.objects`);
    if (by === 'transforms') wires.push(`${place}.objects -> scene-0000.objects`, `${place}.objects -> shadow-0000.casters`);
  }
  if (by === 'copies') {
    nodes['copies-0000'] = ['objects/copies', { count: COUNT, stepM: STEP }];
    wires.push('place-0000.objects -> copies-0000.objects');
    wires.push('copies-0000.objects -> scene-0000.objects', 'copies-0000.objects -> shadow-0000.casters');
  }
  return compileText(projectText({ nodes, wires }));
}

function apart(a: readonly number[], b: readonly number[]): number {
  return a.filter((value, i) => Math.abs(value - (b[i] ?? 0)) > 1).length;
}

test('copies look like so many objects, lit and with their shadows, in one draw for all', async () => {
  const copies = await page.call<Played>('play', programOf('copies'), null);
  const transforms = await page.call<Played>('play', programOf('transforms'), null);
  expect([copies.error, transforms.error]).toEqual([0, 0]);
  const alphas = copies.picture.filter((_, i) => i % 4 === 3);
  expect(alphas.filter((alpha) => alpha === 255).length).toBeGreaterThan(250);
  expect(alphas.filter((alpha) => alpha > 60 && alpha < 200).length).toBeGreaterThan(100);
  expect(apart(copies.picture, transforms.picture)).toBe(0);
  // The same passes, and of each all cones at once.
  expect(transforms.draws - copies.draws).toBeGreaterThanOrEqual(2 * (COUNT - 1));
});

test('copies that move are drawn where they are, also when the first ones were out of sight', async () => {
  const away = await page.call<Played>('play', programOf('copies'), ['place-0000', 'positionM', [0, 0.15, 40]]);
  expect(away.picture.every((value) => value === 0)).toBe(true);
  const far = programOf('copies');
  const numbers = far.slots.numbers.slice();
  const slot = far.slots.slots[far.slots.params['place-0000.positionM'] ?? -1];
  numbers.splice(slot?.offset ?? 0, 3, 0, 0.15, 40);
  const back = await page.call<Played>('play', { ...far, slots: { ...far.slots, numbers } }, [
    'place-0000',
    'positionM',
    [-0.5, 0.15, 0.3],
  ]);
  const still = await page.call<Played>('play', programOf('copies'), null);
  expect(apart(back.picture, still.picture)).toBe(0);
});
