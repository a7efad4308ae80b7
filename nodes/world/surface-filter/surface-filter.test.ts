import { readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import { type BufferGeometry, Matrix4, Mesh, Vector3 } from 'three';
import { createCaptureRoom } from '../../../export/emulator/rooms/capture-room.ts';
import type { SessionFile } from '../../../export/runtime/sessions/session-format.ts';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { DetectedMesh, DetectedPlane, DetectedSurfaces } from '../../kit/session.ts';
import { definition } from './definition.ts';
import { areaOf, convexHull, distanceTo, sideAngleRad, writeCentroid } from './polygon.ts';
import { create } from './runtime.ts';

type Params = NonNullable<NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params']>;
type Place = readonly [x: number, y: number, z: number];

const rounded = (numbers: ArrayLike<number>) => Array.from(numbers, (x) => Math.round(x * 1e3) / 1e3 + 0);

/** A rectangle whose longer side is turned by an angle about the vertical. */
function level(
  id: string,
  at: Place,
  [width, depth]: readonly [number, number],
  more: Partial<DetectedPlane> & { readonly turnRad?: number } = {},
): DetectedPlane {
  const { turnRad = 0, ...rest } = more;
  const worldFromSurface = new Float32Array(new Matrix4().makeRotationY(turnRad).setPosition(...at).elements);
  const outlineXZ = Float32Array.of(-width / 2, -depth / 2, width / 2, -depth / 2, width / 2, depth / 2, -width / 2, depth / 2);
  return { id, version: 0, label: id.split(' ')[0] ?? '', orientation: 'horizontal', worldFromSurface, outlineXZ, ...rest };
}

/** A wall that faces +z, or -z where its matrix is turned over, as some devices give it. */
function wall(id: string, at: Place, [width, height]: readonly [number, number], isTurned = false): DetectedPlane {
  const matrix = new Matrix4().makeRotationX(isTurned ? -Math.PI / 2 : Math.PI / 2).setPosition(...at);
  return { ...level(id, at, [width, height]), orientation: 'vertical', worldFromSurface: new Float32Array(matrix.elements) };
}

function start(params: Params = {}, eyes: Place = [0, 1.6, 0]) {
  const frame = createSessionFrame() as ReturnType<typeof createSessionFrame> & { surfaces: DetectedSurfaces | null };
  frame.viewCount = 1;
  frame.views[0]?.worldFromView.set(new Matrix4().setPosition(...eyes).elements);
  const session = { sessions: 1 };
  const fake = fakeContext(definition, { params, services: { session: session as never } });
  const outline = { version: 0, items: [] as { readonly root: unknown; readonly worldFromObject: Matrix4 }[] };
  Object.assign(fake.ctx.outputs, { outline });
  const node = create(fake.ctx);
  const { outputs } = fake.ctx;
  const see = (planes: readonly DetectedPlane[], meshes: readonly DetectedMesh[] = []) => {
    frame.surfaces = { planes, meshes };
    fake.tick(1 / 60);
    node.update(frame);
    return {
      at: outputs.pose.valid ? rounded(outputs.pose.worldFromPose.slice(12, 15)) : null,
      label: outputs.label.value,
      count: outputs.count.value,
      sizeM: rounded(outputs.sizeM.value),
    };
  };
  const axis = (column: number) => rounded(outputs.pose.worldFromPose.slice(4 * column, 4 * column + 3));
  const moveEyes = (to: Place) => void frame.views[0]?.worldFromView.set(new Matrix4().setPosition(...to).elements);
  return { ...fake, node, session, outline, see, axis, moveEyes };
}

describe('a polygon', () => {
  test('has the area, centroid and hull that follow by hand', () => {
    const centroid = new Float64Array(2);
    // An L of three unit squares: (0, 0)–(2, 1) and (0, 1)–(1, 2), in both directions.
    const corners = [0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2];
    const reversed = [0, 2, 1, 2, 1, 1, 2, 1, 2, 0, 0, 0];
    for (const xz of [corners, reversed]) {
      writeCentroid(centroid, xz);
      expect([areaOf(xz), ...centroid]).toEqual([3, 2.5 / 3, 2.5 / 3].map((x) => expect.closeTo(x, 9)));
      expect(areaOf(convexHull(xz))).toBeCloseTo(3.5, 9);
    }
    expect([distanceTo(corners, 0.5, 0.5), distanceTo(corners, 1.5, 1.5), distanceTo(corners, 2, 4)]).toEqual([
      0,
      0.5,
      expect.closeTo(Math.sqrt(5), 9),
    ]);
  });

  test('lies along its side, however it is turned', () => {
    for (const rad of [0, 0.3, 1, -1.2]) {
      const turned = level('a', [0, 0, 0], [2, 1]).outlineXZ;
      const xz = Array.from({ length: 4 }, (_, i) => {
        const [x = 0, z = 0] = [turned[2 * i], turned[2 * i + 1]];
        return [x * Math.cos(rad) - z * Math.sin(rad), x * Math.sin(rad) + z * Math.cos(rad)];
      }).flat();
      const quarter = (sideAngleRad(xz) - rad) / (Math.PI / 2);
      expect(Math.abs(quarter - Math.round(quarter))).toBeCloseTo(0, 5);
    }
  });
});

describe('world/surface-filter', () => {
  const floor = level('floor', [0, 0, 0], [5, 4]);
  const small = level('table small', [1, 0.7, -1], [0.6, 0.6]);
  const large = level('table large', [-1, 0.7, -2], [1.6, 0.8], { turnRad: 0.3 });
  const ceiling = level('ceiling', [0, 2.5, 0], [5, 4]);
  const back = wall('wall back', [0, 1.2, -2], [5, 2.4]);
  const turned = wall('wall turned', [0, 1.2, 3], [5, 2.4], true);
  const room = [floor, small, large, ceiling, back, turned];

  test('finds the largest table, with its size along its sides', () => {
    const { ctx, see, axis } = start({ labels: 'desk, Table' });
    expect(see(room)).toEqual({ at: [-1, 0.7, -2], label: 'table', count: 2, sizeM: [1.6, 0.8] });
    // z points to the side that faces the visitor.
    expect([axis(1), axis(2)]).toEqual([[0, 1, 0], rounded([Math.sin(0.3), 0, Math.cos(0.3)])]);
    const { areaSquareM, heightM, distanceM } = ctx.outputs;
    const worldFromTable = new Matrix4().fromArray(large.worldFromSurface);
    const eyes = new Vector3(0, 1.6, 0);
    let nearestM = Number.POSITIVE_INFINITY;
    for (let x = -80; x <= 80; x++) {
      for (let z = -40; z <= 40; z++) {
        nearestM = Math.min(nearestM, new Vector3(x / 100, 0, z / 100).applyMatrix4(worldFromTable).distanceTo(eyes));
      }
    }
    expect([areaSquareM.value, heightM.value, distanceM.value]).toEqual([1.28, 0.7, nearestM].map((x) => expect.closeTo(x, 3)));
  });

  test('finds the nearest wall by its surface, turned to the visitor whichever way its matrix faces', () => {
    const { see, axis, moveEyes } = start({ facing: 'wall', choose: 'nearest' });
    expect(see(room)).toMatchObject({ at: [0, 1.2, -2], count: 2, sizeM: [5, 2.4] });
    expect([axis(1), axis(2)]).toEqual([
      [0, 0, 1],
      [0, -1, 0],
    ]);
    moveEyes([2.4, 1.6, 2.5]);
    expect(see(room)).toMatchObject({ at: [0, 1.2, 3] });
    expect([axis(0), axis(1)]).toEqual([
      [-1, 0, 0],
      [0, 0, -1],
    ]);
  });

  test.each<readonly [Params, readonly number[] | null, number]>([
    [{}, [0, 0, 0], 6],
    [{ facing: 'floor' }, [0, 0, 0], 3],
    [{ facing: 'ceiling' }, [0, 2.5, 0], 1],
    [{ facing: 'sloped' }, null, 0],
    [{ facing: 'floor', minHeightM: 0.3, maxHeightM: 1.2 }, [-1, 0.7, -2], 2],
    [{ facing: 'floor', minHeightM: 0.3, leastSideM: 0.9 }, null, 0],
    [{ choose: 'highest' }, [0, 2.5, 0], 6],
    [{ facing: 'floor', choose: 'lowest' }, [0, 0, 0], 3],
    [{ labels: 'sofa' }, null, 0],
    [{ kind: 'meshes' }, null, 0],
  ])('with %j', (params, at, count) => {
    expect(start(params).see(room)).toMatchObject({ at, count });
  });

  test('turns to another surface only where it is better by 10 %, and raises the jumps of its pose', () => {
    const { ctx, see } = start({ facing: 'floor' });
    const grown = (width: number) => see([level('first', [0, 0, 0], [2, 1]), level('second', [3, 0, 0], [width, 1])]);
    const [first, second] = [level('a', [0, 0, 0], [2, 1]), level('b', [3, 0, 0], [1, 1])];
    const grow = (width: number) => {
      Object.assign(second, { outlineXZ: level('b', [3, 0, 0], [width, 1]).outlineXZ, version: second.version + 1 });
      return see([first, second]).at?.[0];
    };
    expect([grow(1), grow(2.1)]).toEqual([0, 0]);
    const { jumps } = ctx.outputs.pose;
    expect([grow(2.3), ctx.outputs.pose.jumps > jumps]).toEqual([3, true]);
    expect(grow(1.9)).toBe(3);
    expect(grown(1)).toMatchObject({ count: 2, label: 'first' });
  });

  test('keeps its axes while the visitor walks around, and forgets the surface with the session', () => {
    const { session, see, axis, moveEyes } = start({ labels: 'table' });
    see([large]);
    const before = axis(2);
    moveEyes([-1, 1.6, -9]);
    see([large]);
    expect(axis(2)).toEqual(before);
    session.sessions++;
    see([large]);
    expect(axis(2)).toEqual(before.map((x) => -x + 0));
  });

  test('finds nothing where there is nothing, and nothing that has no area', () => {
    const { ctx, see, outline } = start();
    expect(see([floor])).toMatchObject({ at: [0, 0, 0] });
    expect(outline.items).toHaveLength(1);
    const nothing = { at: null, label: '', count: 0, sizeM: [0, 0] };
    expect([see([]), see([level('line', [0, 0, 0], [2, 0])])]).toEqual([nothing, nothing]);
    expect([ctx.outputs.isFound.value, ctx.outputs.distanceM.value, outline.items.length]).toEqual([false, 0, 0]);
  });

  test('draws a band along the inside of the outline', () => {
    const { set, see, outline } = start();
    set('bandM', 0.1);
    see([level('floor', [0, 0, 0], [2, 1])]);
    const area = () => {
      const [item] = outline.items;
      const geometry = item?.root instanceof Mesh ? (item.root.geometry as BufferGeometry) : null;
      const { position } = geometry?.attributes ?? {};
      if (!geometry?.index || !position) throw new Error('There is no band.');
      let sum = 0;
      const corner = (i: number) => new Vector3().fromBufferAttribute(position, geometry.index?.getX(i) ?? 0);
      for (let i = 0; i < geometry.index.count; i += 3) {
        const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
        sum += b.sub(a).cross(c.sub(a)).length() / 2;
      }
      return sum;
    };
    expect(area()).toBeCloseTo(2 - 1.8 * 0.8, 6);
    set('bandM', 0.2);
    see([level('floor', [0, 0, 0], [2, 1])]);
    expect(area()).toBeCloseTo(2 - 1.6 * 0.6, 6);
  });

  test('finds the top of a mesh, and no mesh of a room', () => {
    const box = (id: string, at: Place, half: Place): DetectedMesh => {
      const positions = Float32Array.from(
        [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1].map((s, k) => s * (half[k] ?? 0))),
      );
      // The mesh’s own space lies on its side, as devices may give it.
      const worldFromSurface = new Float32Array(new Matrix4().makeRotationX(Math.PI / 2).setPosition(...at).elements);
      return { id, version: 0, label: id, worldFromSurface, positions, indices: Uint32Array.of(0, 1, 2) };
    };
    const meshes = [
      box('couch', [1, 0.4, -2], [1, 0.5, 0.4]),
      box('global mesh', [0, 1.2, 0], [2.5, 2.5, 1.2]),
      box('hall', [0, 1, 0], [4, 4, 1]),
    ];
    expect(start({ kind: 'meshes' }).see([], meshes)).toEqual({ at: [1, 0.8, -2], label: 'couch', count: 1, sizeM: [2, 1] });
  });
});

/** What IWER uses of the browser’s class. */
class Point {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly w: number;
  constructor(x = 0, y = 0, z = 0, w = 1) {
    this.x = x;
    this.y = y;
    this.z = z;
    this.w = w;
  }
}
Object.assign(globalThis, { DOMPointReadOnly: Point });

/** As a device with such a room would detect them. */
function detected(
  planes: readonly {
    readonly label: string;
    readonly orientation: 'horizontal' | 'vertical';
    readonly worldFromPlane: readonly number[];
    readonly polygonXZ: readonly (readonly [number, number])[];
  }[],
): DetectedPlane[] {
  return planes.map(({ label, orientation, worldFromPlane, polygonXZ }, i) => ({
    id: `plane ${i}`,
    version: 0,
    label,
    orientation,
    worldFromSurface: Float32Array.from(worldFromPlane),
    outlineXZ: Float32Array.from(polygonXZ.flat()),
  }));
}

describe('in real and recorded rooms', () => {
  test.each(['living_room', 'meeting_room', 'music_room', 'office_large', 'office_small'])(
    '%s: the floor, the largest table and the walls',
    (name) => {
      const capture: unknown = JSON.parse(readFileSync(`node_modules/@iwer/sem/captures/${name}.json`, 'utf8'));
      const { planes, meshes } = createCaptureRoom(capture);
      const all = detected(planes);
      const lowestM = Math.min(...planes.map(({ worldFromPlane }) => worldFromPlane[13] ?? 0));
      const lowest = start({ facing: 'floor', choose: 'lowest' }).see(all);
      expect([lowest.label, lowest.at?.[1]]).toEqual(['floor', expect.closeTo(lowestM, 2)]);
      const eyes: Place = [0, lowestM + 1.6, 0];
      const { ctx, see } = start({ facing: 'wall', choose: 'nearest' }, eyes);
      const walls = see(all);
      expect(walls.count).toBeGreaterThanOrEqual(4);
      expect(ctx.outputs.distanceM.value).toBeGreaterThan(0);
      // One room has a shelf above the eyes that its scan calls a table, and all tables with normals that point down.
      const tables = all.filter(({ label, worldFromSurface }) => label === 'table' && (worldFromSurface[13] ?? 0) < eyes[1]);
      const table = start({ labels: 'table', facing: 'floor' }, eyes).see(all);
      expect(table.count).toBe(tables.length);
      if (tables.length > 0) expect(table.sizeM[0] ?? 0).toBeGreaterThan(0.2);
      const things = meshes.map(
        ({ label, worldFromMesh, vertices, indices }, i): DetectedMesh => ({
          id: `mesh ${i}`,
          version: 0,
          label,
          worldFromSurface: Float32Array.from(worldFromMesh),
          positions: vertices,
          indices,
        }),
      );
      const furniture = start({ kind: 'meshes' }).see([], things);
      // The scan of the whole room is none of them.
      expect(furniture.count).toBe(things.filter(({ label }) => label !== 'global mesh').length);
    },
  );

  test('the recorded studio: its table, its couch by height, and the wall before the visitor', () => {
    const { surfaces = [] } = JSON.parse(readFileSync('examples/sessions/studio/session.json', 'utf8')) as SessionFile;
    const all = detected(surfaces as Parameters<typeof detected>[0]);
    expect(start({ labels: 'table' }).see(all)).toMatchObject({ at: [-0.2, 0.423, -0.42], sizeM: [1.05, 0.56] });
    expect(start({ facing: 'floor', minHeightM: 0.3, maxHeightM: 0.6 }).see(all)).toMatchObject({ label: 'couch', count: 2 });
    expect(start({ labels: 'wall', choose: 'nearest' }, [0, 1.5, -1.5]).see(all)).toMatchObject({ at: [0, 1.3, -2.3], count: 4 });
  });
});
