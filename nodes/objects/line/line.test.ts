import { describe, expect, test } from '@jest/globals';
import { Box3, Matrix4, Mesh, type MeshBasicMaterial, Vector3 } from 'three';
import { setFrustum } from '../../../export/runtime/sessions/matrix.ts';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start() {
  const poses = { from: createPose(), to: createPose() };
  const { ctx, set } = fakeContext(definition, { params: { widthM: 0.02 }, inputs: poses });
  const node = create(ctx);
  const list = ctx.outputs.objects;
  const matrix = new Float32Array(16);
  const put = (name: 'from' | 'to', at: readonly number[] | null) => {
    if (at) setFromAngles(matrix, at, [1, 2, 3]);
    writePose(poses[name], at && matrix, 0);
  };
  /** Center and size of its box in world space; null without a line. */
  const seen = () => {
    node.update({} as never);
    const [item] = list.items;
    if (!item) return null;
    const { geometry } = item.root as Mesh;
    const box = new Box3().setFromBufferAttribute(geometry.getAttribute('position') as never).applyMatrix4(item.worldFromObject);
    const round = (v: Vector3) => v.toArray().map((x) => Math.round(x * 1e4) / 1e4 + 0);
    return [round(box.getCenter(new Vector3())), round(box.getSize(new Vector3()))];
  };
  const line = () => {
    const [item] = list.items;
    if (!item) throw new Error('There is no line.');
    const { geometry, material } = item.root as Mesh;
    return { item, geometry, material: material as MeshBasicMaterial };
  };
  return { node, list, put, seen, set, line };
}

/** A line with a width in pixels, seen in 400 × 300 pixels; `ipdM` makes two eyes. */
function startInPixels(from: readonly number[], to: readonly number[], widthPx: number, ipdM = 0) {
  const poses = { from: createPose(), to: createPose() };
  const matrix = new Float32Array(16);
  for (const [name, at] of [
    ['from', from],
    ['to', to],
  ] as const) {
    setFromAngles(matrix, at, [0, 0, 0]);
    writePose(poses[name], matrix, 0);
  }
  const { ctx } = fakeContext(definition, { params: { widthIn: 'pixels', widthPx }, inputs: poses });
  const frame = createSessionFrame();
  frame.viewCount = ipdM > 0 ? 2 : 1;
  frame.views.forEach((view, i) => {
    Object.assign(view, { viewport: { x: 0, y: 0, widthPx: 400, heightPx: 300 }, nearM: 0.1 });
    setFrustum(view.clipFromView, -0.8, 0.8, -0.6, 0.6, 0.1, 100);
    setFromAngles(view.worldFromView, [(i - 0.5) * ipdM, 0, 0], [0, 0, 0]);
  });
  create(ctx).update(frame);
  const list = ctx.outputs.objects;
  /** The corners in the image, pixels from its center, of an eye. */
  const corners = (eye = 0): (readonly [number, number])[] => {
    const { position } = ((list.items[0]?.root ?? new Mesh()) as Mesh).geometry.attributes;
    const clip = new Matrix4().fromArray(frame.views[eye]?.clipFromView ?? []);
    const view = new Matrix4().fromArray(frame.views[eye]?.worldFromView ?? []).invert();
    return Array.from({ length: position?.count ?? 0 }, (_, i) => {
      const at = new Vector3()
        .fromBufferAttribute(position as never, i)
        .applyMatrix4(view)
        .applyMatrix4(clip);
      return [at.x * 200, at.y * 150] as const;
    });
  };
  return { list, corners };
}

describe('objects/line', () => {
  test.each([
    ['along x', [3, 1, 2], [2, 1, 2], [2, 0.02, 0.02]],
    ['along z', [1, 1, -2], [1, 1, 0], [0.02, 0.02, 4]],
    ['up', [1, 2, 2], [1, 1.5, 2], [0.02, 1, 0.02]],
    ['down', [1, 0, 2], [1, 0.5, 2], [0.02, 1, 0.02]],
  ])('reaches from pose to pose in its width: %s', (_name, to, center, size) => {
    const { put, seen } = start();
    put('from', [1, 1, 2]);
    put('to', to);
    expect(seen()).toEqual([center, size]);
  });

  test('is not there while a pose is invalid, between poses at one position, and without a width', () => {
    const { list, put, seen, set } = start();
    expect(seen()).toBe(null);
    put('from', [1, 1, 2]);
    expect(seen()).toBe(null);
    put('to', [1, 1, 2]);
    expect(seen()).toBe(null);
    put('to', [1, 1, 3]);
    expect(seen()).not.toBe(null);
    const { version } = list;
    put('to', [1, 1, 4]);
    seen();
    // A line that moves is the same object.
    expect(list.version).toBe(version);
    put('from', null);
    expect([seen(), list.version]).toEqual([null, version + 1]);
    put('from', [1, 1, 2]);
    set('widthM', 0);
    expect(seen()).toBe(null);
  });

  test('has its color, which is sRGB, and is transparent with alpha', () => {
    const { put, seen, set, line } = start();
    put('from', [0, 0, 0]);
    put('to', [1, 0, 0]);
    set('color', [0.5, 1, 0, 0.25]);
    set('castShadow', true);
    seen();
    const { item, material } = line();
    // IEC 61966-2-1: ((0.5 + 0.055) / 1.055) ^ 2.4.
    expect(material.color.r).toBeCloseTo(0.21404, 5);
    expect([material.opacity, material.transparent, item.castsShadow]).toEqual([0.25, true, true]);
  });

  test.each([
    ['across, near', [-0.2, 0, -1], [0.2, 0, -1]],
    ['across, far away at the edge', [28, 0, -40], [28, 30, -40]],
    ['from near to far', [-0.3, -0.3, -0.6], [6, 5, -30]],
    ['slanted', [-1, -2, -5], [3, 1, -4]],
  ])('with a width in pixels it is as wide in the image at both ends: %s', (_name, from, to) => {
    const { corners } = startInPixels(from, to, 7);
    const [a, b, c, d] = corners();
    if (!a || !b || !c || !d) throw new Error('There is no line.');
    const along = [c[0] + d[0] - a[0] - b[0], c[1] + d[1] - a[1] - b[1]] as const;
    for (const [one, other] of [
      [a, b],
      [c, d],
    ] as const) {
      const across = [one[0] - other[0], one[1] - other[1]] as const;
      expect(Math.hypot(...across)).toBeCloseTo(7, 2);
      expect((across[0] * along[0] + across[1] * along[1]) / (7 * Math.hypot(...along))).toBeCloseTo(0, 3);
    }
  });

  test('with a width in pixels it is as wide in both eyes of a headset, ends before the viewer and is not there behind', () => {
    const two = startInPixels([-0.5, -0.2, -2], [0.5, 0.3, -6], 5, 0.064);
    for (const eye of [0, 1]) {
      const [a, b] = two.corners(eye);
      if (!a || !b) throw new Error('There is no line.');
      expect(Math.abs(Math.hypot(a[0] - b[0], a[1] - b[1]) - 5)).toBeLessThan(0.05);
    }
    const through = startInPixels([0.2, 0, -2], [-0.3, 0.1, 5], 5);
    expect(through.corners().every(([x, y]) => Number.isFinite(x) && Number.isFinite(y))).toBe(true);
    expect(startInPixels([0, 0, 2], [1, 0, 3], 5).list.items).toEqual([]);
  });

  test('releases its geometry and material', () => {
    const { node, put, seen, line } = start();
    put('from', [0, 0, 0]);
    put('to', [1, 0, 0]);
    seen();
    const { geometry, material } = line();
    let released = 0;
    for (const each of [geometry, material]) each.addEventListener('dispose', () => released++);
    node.dispose();
    expect(released).toBe(2);
  });
});
