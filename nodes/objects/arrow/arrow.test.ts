import { describe, expect, test } from '@jest/globals';
import { Box3, type BufferGeometry, Matrix4, type Mesh, PerspectiveCamera, Vector3 } from 'three';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { signedVolumeM3 } from '../../../tests/support/signed-volume.ts';
import type { ParamValue } from '../../kit/definition.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const ASPECT = 1.5;
const camera = new PerspectiveCamera(60, ASPECT, 0.1, 100);

/** A frame seen from the origin, along -z. */
function frameFromOrigin() {
  const frame = createSessionFrame();
  frame.viewCount = 1;
  frame.views[0]?.clipFromView.set(camera.projectionMatrix.elements);
  return frame;
}

function start(params: Readonly<Record<string, ParamValue>>, isTo = true) {
  const poses = { from: createPose(), to: createPose() };
  const { ctx, set } = fakeContext(definition, { params, inputs: isTo ? poses : { from: poses.from } });
  const node = create(ctx);
  const frame = frameFromOrigin();
  const matrix = new Float32Array(16);
  const put = (name: 'from' | 'to', at: readonly number[] | null, angles: readonly number[] = [0, 0, 0]) => {
    if (at) setFromAngles(matrix, at, angles);
    writePose(poses[name], at && matrix, 0);
  };
  const update = () => {
    node.update(frame);
    const [item] = ctx.outputs.objects.items;
    return item ? { item, geometry: (item.root as Mesh).geometry } : null;
  };
  const drawn = () => {
    const made = update();
    if (!made) throw new Error('There is no arrow.');
    return made;
  };
  return { node, ctx, set, put, update, drawn };
}

function boxOf(geometry: BufferGeometry, matrix: Matrix4): number[][] {
  const box = new Box3().setFromBufferAttribute(geometry.getAttribute('position') as never).applyMatrix4(matrix);
  return [box.min, box.max].map((v) => v.toArray().map((x) => Math.round(x * 1e4) / 1e4 + 0));
}

const WIDE = { widthM: 0.1, headWidth: 3, headLength: 4 };

describe('objects/arrow', () => {
  test('reaches from pose to pose, with its head at the second', () => {
    const { put, drawn } = start(WIDE);
    put('from', [0, 1, 0], [1, 2, 3]);
    put('to', [0, 2, 0]);
    const { item, geometry } = drawn();
    expect(boxOf(geometry, item.worldFromObject)).toEqual([
      [-0.15, 1, -0.15],
      [0.15, 2, 0.15],
    ]);
    // The widest ring is where the head begins.
    const positions = geometry.getAttribute('position');
    const wide = Array.from({ length: positions.count }, (_, i) => i).filter(
      (i) => Math.hypot(positions.getX(i), positions.getZ(i)) > 0.149,
    );
    for (const i of wide) expect(positions.getY(i)).toBeCloseTo(0.6, 6);
  });

  test('without a second pose it points forward as a ray, or up as a normal', () => {
    const forward = start({ ...WIDE, lengthM: 2 }, false);
    forward.put('from', [1, 1, 1], [0, Math.PI / 2, 0]);
    const ray = forward.drawn();
    // Turned left by 90°, -z is -x.
    expect(boxOf(ray.geometry, ray.item.worldFromObject)[0]?.[0]).toBe(-1);
    const up = start({ ...WIDE, lengthM: 2, direction: 'up' }, false);
    up.put('from', [1, 1, 1]);
    const normal = up.drawn();
    expect(boxOf(normal.geometry, normal.item.worldFromObject)[1]?.[1]).toBe(3);
  });

  test('is closed with outward faces: its volume is that of a cylinder and a cone', () => {
    const { put, drawn } = start(WIDE);
    put('from', [0, 0, 0]);
    put('to', [0, 0, -1]);
    const sides = 32;
    const polygon = (radius: number) => 0.5 * sides * radius ** 2 * Math.sin((2 * Math.PI) / sides);
    expect(signedVolumeM3(drawn().geometry)).toBeCloseTo(polygon(0.05) * 0.6 + (polygon(0.15) * 0.4) / 3, 7);
  });

  test('a short arrow has a smaller head of the same angle', () => {
    const { put, drawn } = start(WIDE);
    put('from', [0, 0, 0]);
    put('to', [0, 0.2, 0]);
    const { geometry, item } = drawn();
    expect(boxOf(geometry, item.worldFromObject)).toEqual([
      [-0.075, 0, -0.075],
      [0.075, 0.2, 0.075],
    ]);
  });

  test('with a width on the screen, its shaft is as wide at all distances', () => {
    const { put, drawn } = start({ widthIn: 'screen', widthOfView: 0.02, headLength: 1 });
    put('from', [-1, -0.3, -2]);
    put('to', [1, 0.2, -9]);
    const { item, geometry } = drawn();
    const positions = geometry.getAttribute('position');
    const point = new Vector3();
    // Rings 2 and 3 are the ends of the shaft. The silhouette of a thin rod: its points farthest apart across its direction.
    const clipFromObject = new Matrix4().multiplyMatrices(camera.projectionMatrix, item.worldFromObject);
    const at = (i: number) => point.fromBufferAttribute(positions as never, i).applyMatrix4(clipFromObject);
    const axis = [new Vector3(-1, -0.3, -2), new Vector3(1, 0.2, -9)].map((p) => p.applyMatrix4(camera.projectionMatrix));
    const [near = point, far = point] = axis;
    const direction = [(far.x - near.x) * ASPECT, far.y - near.y];
    const length = Math.hypot(direction[0] ?? 0, direction[1] ?? 0);
    for (const ring of [2, 3]) {
      const offsets = Array.from({ length: 32 }, (_, i) => {
        const { x, y } = at(ring * 32 + i);
        return (x * ASPECT * (direction[1] ?? 0) - y * (direction[0] ?? 0)) / length;
      });
      // Normalized device coordinates are two high. A circle that is seen at an angle is up to 5 % wider here.
      const width = (Math.max(...offsets) - Math.min(...offsets)) / 2;
      expect(width).toBeGreaterThan(0.0195);
      expect(width).toBeLessThan(0.0215);
    }
  });

  test('is not there while a pose is invalid, without length and without width', () => {
    const { put, update, set } = start(WIDE);
    expect(update()).toBe(null);
    put('from', [0, 0, 0]);
    expect(update()).toBe(null);
    put('to', [0, 0, 0]);
    expect(update()).toBe(null);
    put('to', [0, 1, 0]);
    expect(update()).not.toBe(null);
    put('to', [0, Number.NaN, 0]);
    expect(update()).toBe(null);
    put('to', [0, 1, 0]);
    set('widthM', 0);
    expect(update()).toBe(null);
  });

  test('writes its vertices only when its shape changes, not when it moves', () => {
    const { put, drawn } = start(WIDE);
    put('from', [0, 0, 0]);
    put('to', [0, 1, 0]);
    const position = drawn().geometry.getAttribute('position') as unknown as { readonly version: number };
    const { version } = position;
    put('from', [1, 0, 0]);
    put('to', [1, 1, 0]);
    drawn();
    expect(position.version).toBe(version);
    put('to', [1, 1.5, 0]);
    drawn();
    expect(position.version).toBe(version + 1);
  });

  test('releases its geometry', () => {
    const { node, put, drawn } = start({ ...WIDE, shaded: true });
    put('from', [0, 0, 0]);
    put('to', [0, 1, 0]);
    let released = 0;
    drawn().geometry.addEventListener('dispose', () => released++);
    node.dispose();
    expect(released).toBe(1);
  });
});
