import { readFileSync } from 'node:fs';
import { expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/slow/real-surfaces.page.ts');

interface Seen {
  readonly capabilities: readonly string[];
  readonly labels: readonly string[];
  readonly meshes: number;
  readonly rebuilt: boolean;
  readonly points: readonly Shadow[];
  readonly onMesh: readonly Shadow[];
}

interface Shadow {
  readonly shadow: number;
  readonly mirrored: number;
  readonly fromBehind: number;
  readonly error: number;
}

const OFFICE = { capture: JSON.parse(readFileSync('node_modules/@iwer/sem/captures/office_small.json', 'utf8')) };

test.each<readonly [string, EmulatorOptions, number]>([
  ['a scanned office', { device: 'headset', room: OFFICE }, 4],
  ['the studio, by phone', { device: 'phone', room: 'studio' }, 4],
])('shadows fall on every detected plane of %s, away from the light, and not from behind it', async (_, options, least) => {
  const { capabilities, labels, meshes, rebuilt, points, onMesh } = await page.call<Seen>('inRoom', options);
  const headset = options.device === 'headset';
  expect([capabilities, rebuilt, meshes > 0]).toEqual([headset ? ['meshes', 'planes'] : ['planes'], false, headset]);
  expect(labels.length).toBeGreaterThanOrEqual(least);
  expect(new Set(labels.map((label) => label.split(' ').at(-1)))).toEqual(new Set(['horizontal', 'vertical']));
  labels.forEach((label, i) => {
    expect([label, points[i]]).toEqual([label, { shadow: 255, mirrored: 0, fromBehind: 0, error: 0 }]);
  });
  if (headset) {
    // What is scanned is rough, and furniture stands before walls: most of them have a shadow all the same.
    const caught = onMesh.filter(({ shadow, mirrored }) => shadow > 128 && mirrored < 128).length;
    console.log(`${caught} of ${labels.length} balls before planes of the room throw their shadow on its mesh too`);
    expect(caught).toBeGreaterThan(labels.length / 3);
  }
});
