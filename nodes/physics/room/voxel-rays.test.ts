import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { createSpatial } from '../../../export/runtime/spatial/create-spatial.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { BOX, CENTER, EYE, look, SEEN_BOX, SETTINGS } from '../../../tests/support/physics/seen-room.ts';
import { createStage } from '../../../tests/support/physics/stage.ts';
import { createHit } from '../../kit/hit-test.ts';
import { writeVoxelFile } from '../../kit/voxel-file.ts';
import { createVoxelGrid } from '../world/voxel-grid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';
import { createVoxelRays } from './voxel-rays.ts';

const FLOOR_M = 0.01;

function seen(isSmooth: boolean, frame = SEEN_BOX) {
  const grid = createVoxelGrid({ ...SETTINGS, isSmooth });
  for (let i = 0; i < 20; i++) grid.update(frame);
  const rays = createVoxelRays();
  rays.read(writeVoxelFile(grid.save()));
  return rays;
}
function cast(rays: ReturnType<typeof createVoxelRays>, from: Vector3, to: Vector3) {
  const direction = to.clone().sub(from).normalize();
  const out = { distanceM: Number.NaN, nx: 0, ny: 0, nz: 0 };
  const ray = { ox: from.x, oy: from.y, oz: from.z, dx: direction.x, dy: direction.y, dz: direction.z };
  if (!rays.cast(out, ray)) return null;
  const normal = new Vector3(out.nx, out.ny, out.nz);
  return { point: direction.multiplyScalar(out.distanceM).add(from), normal, distanceM: out.distanceM };
}
const degrees = (a: Vector3, b: Vector3) => (Math.acos(Math.min(1, a.dot(b))) * 180) / Math.PI;

describe.each([
  ['voxels', false, 0.026, 3],
  ['a smooth surface', true, 0.004, 2],
] as const)('rays through a room of %s', (_, isSmooth, mostM, mostDeg) => {
  const rays = seen(isSmooth);
  const up = new Vector3(0, 1, 0);

  test('meet the top of a box and the floor, also steeply and from where nobody looked', () => {
    for (const from of [EYE, new Vector3(0, 2, 0), new Vector3(-1, 1.2, 0.4)]) {
      for (const [x, z] of [
        [0, 0],
        [0.1, -0.05],
        [-0.08, 0.12],
      ] as const) {
        const hit = cast(rays, from, new Vector3(x, BOX.top, z));
        expect(Math.abs((hit?.point.y ?? 9) - BOX.top)).toBeLessThan(mostM);
        expect(degrees(hit?.normal ?? new Vector3(), up)).toBeLessThan(mostDeg);
      }
      const onFloor = cast(rays, from, new Vector3(0.5, FLOOR_M, 0.5));
      expect(Math.abs((onFloor?.point.y ?? 9) - FLOOR_M)).toBeLessThan(mostM);
      expect(degrees(onFloor?.normal ?? new Vector3(), up)).toBeLessThan(mostDeg);
    }
  });

  test('meet its front as a wall, with the normal towards the ray', () => {
    const hit = cast(rays, EYE, new Vector3(0.02, 0.2, BOX.half));
    expect(Math.abs((hit?.point.z ?? 9) - BOX.half)).toBeLessThan(mostM);
    expect(degrees(hit?.normal ?? new Vector3(), new Vector3(0, 0, 1))).toBeLessThan(mostDeg + 3);
  });

  test('pass where nothing was seen, and from behind', () => {
    expect(cast(rays, EYE, EYE.clone().add(new Vector3(0, 1, 0)))).toBeNull();
    expect(cast(rays, new Vector3(0.5, -1, 0.5), new Vector3(0.5, 0, 0.5))).toBeNull();
    expect(cast(rays, new Vector3(9, 9, 9), new Vector3(9, 0, 9))).toBeNull();
    expect(createVoxelRays().cast({ distanceM: 0, nx: 0, ny: 0, nz: 0 }, { ox: 0, oy: 1, oz: 0, dx: 0, dy: -1, dz: 0 })).toBe(false);
  });
});

describe('a physics room answers hit tests', () => {
  const DOWN = new Matrix4().lookAt(new Vector3(0.5, 2, 0.5), new Vector3(0.5, 0, 0.5), new Vector3(0, 0, -1)).setPosition(0.5, 2, 0.5);
  /** A room with its world, where depth was seen for some frames. */
  function start() {
    const spatial = createSpatial({ gl: {} as never, held: true });
    const frame = createSessionFrame();
    const session = { sessions: 0, depthImage: () => null, answerRays: spatial.answerRays };
    const fake = fakeContext(definition, { services: { session: session as never }, params: { surface: 'smooth' } });
    const node = create(fake.ctx);
    const stage = createStage({ floor: false });
    const { room } = fake.ctx.outputs.body;
    if (!room) throw new Error('There is no room.');
    stage.list.room = room;
    const play = (frames: number) => {
      for (let i = 0; i < frames; i++) {
        frame.index++;
        spatial.enterFrame(frame);
        stage.play(1, node, fake, frame);
      }
    };
    const see = () => {
      for (let i = 0; i < 20; i++) {
        room.frames.push(SEEN_BOX);
        play(1);
      }
    };
    return { spatial, frame, node, room, play, see };
  }

  test('after depth and before the floor; who asks for none of them costs nothing', () => {
    const { spatial, frame, node, room, play, see } = start();
    see();
    play(100);
    expect(room.file).toBeNull();
    const hit = createHit();
    expect(spatial.castRay(DOWN.elements, hit, ['plane', 'depth'])).toBe(false);
    play(60);
    expect(room.file).toBeNull();
    const hits = spatial.openHitTest({ from: 'viewer' });
    const [view] = frame.views;
    view?.worldFromView.set(DOWN.elements);
    frame.viewCount = 1;
    play(1);
    expect(hits.read().at(0).source).toBe('floor');
    play(60);
    const found = hits.read().at(0);
    expect([found.source, found.anchorable, Math.round(1000 * found.distanceM)]).toEqual(['voxels', false, 1990]);
    expect(found.worldFromHit[5]).toBeGreaterThan(0.999);
    node.dispose?.();
    play(1);
    expect(hits.read().at(0).source).toBe('floor');
  });

  test('at their new place after world space has moved, never at the old one', () => {
    const { spatial, frame, play, see } = start();
    see();
    const hits = spatial.openHitTest({ from: 'viewer' });
    frame.views[0]?.worldFromView.set(DOWN.elements);
    frame.viewCount = 1;
    play(60);
    expect(hits.read().at(0).distanceM).toBeCloseTo(1.99, 2);
    Object.assign(frame, { jumps: frame.jumps + 1, worldFromFormer: new Matrix4().makeTranslation(0, 0.3, 0).elements });
    const after: string[] = [];
    for (let i = 0; i < 60; i++) {
      play(1);
      const { source, distanceM } = hits.read().at(0);
      const told = `${source} ${distanceM.toFixed(2)}`;
      if (after.at(-1) !== told) after.push(told);
    }
    expect(after).toEqual(['floor 2.00', 'voxels 1.69']);
  });

  test('where the visitor looks away or depth has a hole', () => {
    const rays = seen(
      true,
      look(EYE, CENTER, () => 1.2),
    );
    const { spatial } = start();
    spatial.answerRays(rays);
    const hit = createHit();
    const toMiddle = new Matrix4().lookAt(EYE, CENTER, new Vector3(0, 1, 0)).setPosition(EYE);
    expect(spatial.castRay(toMiddle.elements, hit, ['depth', 'voxels'])).toBe(true);
    expect([hit.source, hit.distanceM.toFixed(2)]).toEqual(['voxels', '1.20']);
  });
});
