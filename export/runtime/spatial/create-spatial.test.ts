import { describe, expect, test } from '@jest/globals';
import type { DetectedPlane, RoomDepth } from '../../../nodes/kit/session.ts';
import { addPointer, createPointer } from '../sessions/input/session-input.ts';
import { setFrustum } from '../sessions/matrix.ts';
import { createSessionFrame } from '../sessions/session-frame.ts';
import { createSpatial } from './create-spatial.ts';

/** Looks straight down from 2 m. */
const DOWN = [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 2, 0, 1];

/** No device, no planes, no depth: an orbit session's frame. */
function start() {
  const spatial = createSpatial({ gl: {} as never, held: true });
  const frame = createSessionFrame();
  const [view] = frame.views;
  if (!view) throw new Error('There is no view.');
  frame.viewCount = 1;
  frame.index = 7;
  view.worldFromView.set(DOWN);
  setFrustum(view.clipFromView, -1, 1, -1, 1, 0.05, 100);
  return { spatial, frame, view };
}

function tableAt(heightM: number): DetectedPlane {
  return {
    id: 'table',
    version: 0,
    label: 'table',
    orientation: 'horizontal',
    worldFromSurface: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, heightM, 0, 1),
    outlineXZ: Float32Array.of(-1, -1, 1, -1, 1, 1, -1, 1),
  };
}

/** Everything `meters` away, on the CPU, as recordings have it. */
function depthOf(meters: number): RoomDepth {
  return {
    texture: {} as WebGLTexture,
    widthPx: 8,
    heightPx: 8,
    uvFromViewUv: Float32Array.of(1, 0, 0, 0, -1, 0, 0, 1, 1),
    worldFromDepth: Float32Array.from(DOWN),
    meters: new Float32Array(64).fill(meters),
  };
}

describe('hit tests', () => {
  test('are answered by planes, then by depth, then by the floor', () => {
    const { spatial, frame, view } = start();
    const hits = spatial.openHitTest({ from: 'viewer' });
    const read = () => {
      spatial.enterFrame(frame);
      const list = hits.read();
      const { source, distanceM, label, frame: index } = list.at(0);
      return [list.count, source, Math.round(distanceM * 1e4) / 1e4, label, index];
    };
    expect(read()).toEqual([1, 'floor', 2, '', 7]);
    frame.index++;
    view.depth = depthOf(1.5);
    expect(read()).toEqual([1, 'depth', 1.5, '', 8]);
    frame.surfaces = { planes: [tableAt(0.7), tableAt(0.2)], meshes: [] };
    expect(read()).toEqual([1, 'plane', 1.3, 'table', 8]);
  });

  test('are answered by the sources that are asked for', () => {
    const { spatial, frame } = start();
    frame.surfaces = { planes: [tableAt(0.7)], meshes: [] };
    spatial.enterFrame(frame);
    const count = (...sources: ('plane' | 'depth' | 'floor')[]) => spatial.openHitTest({ from: 'viewer', sources }).read().count;
    expect([count('floor'), count('plane', 'floor'), count('depth')]).toEqual([1, 1, 0]);
    expect(spatial.counts().hitTests).toBe(3);
    spatial.dispose();
    expect(spatial.counts().hitTests).toBe(0);
  });

  test('of pointers are one for each, with its id', () => {
    const { spatial, frame } = start();
    const hits = spatial.openHitTest({ from: 'pointers' });
    for (const id of [4, 9]) {
      const pointer = Object.assign(createPointer(), { id });
      pointer.worldFromRay.set(DOWN);
      pointer.worldFromRay[12] = id;
      addPointer(frame.input, pointer);
    }
    spatial.enterFrame(frame);
    const list = hits.read();
    expect([0, 1].map((i) => [list.at(i).pointer, list.at(i).worldFromHit[12]])).toEqual([
      [4, 4],
      [9, 9],
    ]);
    expect(() => list.at(2)).toThrow(RangeError);
  });

  test('keep to an offset ray, and give nothing when closed or for a ray that is none', () => {
    const { spatial, frame, view } = start();
    const moved = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1];
    const hits = spatial.openHitTest({ from: 'viewer', offsetRay: moved });
    spatial.enterFrame(frame);
    expect(hits.read().at(0).worldFromHit[12]).toBeCloseTo(0.5, 6);
    view.worldFromView[0] = Number.NaN;
    view.worldFromView[8] = Number.NaN;
    spatial.enterFrame(frame);
    expect(hits.read().count).toBe(0);
    view.worldFromView.set(DOWN);
    hits.close();
    spatial.enterFrame(frame);
    expect(hits.read().count).toBe(0);
  });
});

describe('anchors without a device', () => {
  test('are ideal, until they are deleted or the session ends', () => {
    const { spatial, frame } = start();
    spatial.enterFrame(frame);
    const hit = spatial.openHitTest({ from: 'viewer' }).read().at(0);
    const [first, second] = [spatial.anchors.create(hit), spatial.anchors.create(DOWN)];
    expect([first.state, second.state, first.id === second.id]).toEqual(['tracked', 'tracked', false]);
    expect([[...first.worldFromAnchor], [...second.worldFromAnchor]]).toEqual([[...hit.worldFromHit], DOWN]);
    expect([spatial.counts().anchors, spatial.settle()]).toEqual([2, null]);
    first.delete();
    expect([first.state, spatial.counts().anchors]).toEqual(['deleted', 1]);
    spatial.leaveSession();
    expect([second.state, [...second.worldFromAnchor], spatial.counts().anchors]).toEqual(['deleted', DOWN, 0]);
  });

  test.each([
    ['too few numbers', [1, 0, 0]],
    ['NaN', DOWN.map((x, i) => (i === 12 ? Number.NaN : x))],
  ])('refuse a pose with %s', (_what, pose) => {
    const { spatial, frame } = start();
    spatial.enterFrame(frame);
    expect(() => spatial.anchors.create(pose)).toThrow(RangeError);
    expect(spatial.counts().anchors).toBe(0);
  });
});
