import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { type Acquired, acquire, placeText } from '../support/acquisition.ts';
import { projectText, writeProject } from '../support/project-kit.ts';
import { succeed } from '../support/scrim.ts';

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-highlight-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

const DISTANCE_M = 1.2;
/** The radius of the ball is then 0.2 m / 1.2 m / tan 30° · 256 px = 74 px. */
const SIDE_PX = 512;

const GLOSSY_BALL = projectText({
  nodes: {
    'ball-a1': ['objects/primitive', { shape: 'sphere', sizeM: [0.4, 0.4, 0.4], color: [0.55, 0.15, 0.12, 1], roughness: 0.35 }],
    'lift-b1': ['objects/transform', { positionM: [0, 0.4, 0] }],
    'sun-c1': ['light/directional', { intensity: 3, azimuthRad: 0.6, elevationRad: 0.9 }],
    'scene-d1': 'layer/scene',
    'screen-e1': 'output/screen',
  },
  wires: [
    ...['ball-a1.objects -> lift-b1.objects', 'lift-b1.objects -> scene-d1.objects'],
    ...['sun-c1.lights -> scene-d1.lights', 'scene-d1.layer -> screen-e1.layer'],
  ],
});
const AROUND = ['--center', '0,0.4,0', '--extent', String(2 * DISTANCE_M), '--fov', '60'];
/** From where the highlight is well visible. None of them is a camera of the capture. */
const HELD_OUT = [...AROUND, '--count', '8', '--elevation', '20..70', '--size', `${SIDE_PX}x${SIDE_PX}`];

test('a highlight on a captured ball moves with the eye as on the ball itself, and not without the photographs', async () => {
  const [ball, photos, place] = [join(base, 'ball'), join(base, 'photos'), join(base, 'place')];
  await writeProject(ball, { 'project.scrim.json': GLOSSY_BALL });
  await succeed('capture', ball, '--out', photos, '--count', '42', ...AROUND, '--size', '256x256');
  await writeProject(place, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
  await succeed('import', 'capture', photos, '--project', place);
  const look = async (params: Readonly<Record<string, unknown>>): Promise<readonly Acquired[]> => {
    await writeProject(place, { 'project.scrim.json': placeText('assets/photos.capture/capture.json', params) });
    return acquire(place, join(base, 'shown'), ...HELD_OUT);
  };
  const truth = (await acquire(ball, join(base, 'truth'), ...HELD_OUT)).map(highlightOf);
  const shown = (await look({ method: 'lumigraph', blended: 4 })).map(highlightOf);
  const plain = (await look({ method: 'plain' })).map(highlightOf);
  const offPx = (places: readonly Place[]) => places.map(([x, y], i) => Math.hypot(x - (truth[i]?.[0] ?? 0), y - (truth[i]?.[1] ?? 0)));
  if (process.env.SCRIM_PICTURES) console.log(truth, offPx(shown), offPx(plain));
  expect(truth).toHaveLength(8);
  expect(Math.max(...offPx(shown))).toBeLessThan(4);
  // The colors of the mesh have it in one place of the ball, so that it is far from its true place in most views.
  expect(offPx(plain).filter((px) => px > 4).length).toBeGreaterThan(4);
});

type Place = readonly [columnPx: number, rowPx: number];

/** The center of what is brighter than the matte ball: blue, of which the ball has least, above its median by a tenth of its range. */
function highlightOf({ pixels, widthPx }: Acquired): Place {
  const blues: number[] = [];
  for (let i = 0; i < pixels.length; i += 4) if (pixels[i + 3] === 255) blues.push(pixels[i + 2] ?? 0);
  blues.sort((a, b) => a - b);
  const middle = blues[blues.length >> 1] ?? 0;
  const least = middle + 0.1 * ((blues.at(-1) ?? 0) - middle);
  let [sum, x, y] = [0, 0, 0];
  for (let i = 0; i < pixels.length; i += 4) {
    const above = pixels[i + 3] === 255 ? (pixels[i + 2] ?? 0) - least : 0;
    if (above <= 0) continue;
    sum += above;
    x += above * ((i >> 2) % widthPx);
    y += above * Math.floor((i >> 2) / widthPx);
  }
  return [x / sum, y / sum];
}
