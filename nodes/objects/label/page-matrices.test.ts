import { describe, expect, test } from '@jest/globals';
import { PerspectiveCamera, Vector3 } from 'three';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { createLabelPose } from './label-pose.ts';
import { FONT_PX } from './layout.ts';
import { createPageMatrices } from './page-matrices.ts';

const OVERLAY = { overlayWidthPx: 900, overlayHeightPx: 600 };
const CARD = { widthPx: 320, heightPx: 96 };
const SIZE_M = 0.1;

function seenFrom(position: readonly [number, number, number]) {
  const camera = new PerspectiveCamera(50, 1.5, 0.1, 100);
  camera.position.set(...position);
  camera.lookAt(0.1, 0.2, 0);
  camera.rotateZ(0.2);
  camera.updateMatrixWorld();
  const frame = createSessionFrame();
  frame.viewCount = 1;
  frame.framebufferWidthPx = 1800;
  frame.framebufferHeightPx = 1200;
  const [view] = frame.views;
  if (!view) throw new Error('The frame has no view.');
  view.clipFromView.set(camera.projectionMatrix.elements);
  view.worldFromView.set(camera.matrixWorld.elements);
  view.viewFromWorld.set(camera.matrixWorldInverse.elements);
  view.nearM = 0.1;
  Object.assign(view.viewport, { x: 0, y: 0, widthPx: 1800, heightPx: 1200 });
  return { camera, frame };
}

/** Where CSS draws a point of an element with `matrix3d` (CSS Transforms Level 2 §9). */
function drawnAt(m: Float64Array, x: number, y: number): number[] {
  const row = (i: number) => (m[i] ?? 0) * x + (m[4 + i] ?? 0) * y + (m[12 + i] ?? 0);
  return [row(0) / row(3), row(1) / row(3)];
}

const box = () => ({ left: 0, right: 0, bottom: 0, top: 0 });

describe('labels in the page', () => {
  test.each<['viewer' | 'surface' | 'pose', [number, number, number]]>([
    ['pose', [0.5, 1, 3]],
    ['pose', [-2, -1, 2]],
    ['surface', [1, 2, 1.5]],
    ['surface', [-0.3, 3, 0.4]],
    ['viewer', [2, 0.5, -2]],
    ['viewer', [0, 3, 0.5]],
  ])('the corners of a label that faces %s, seen from %p, are where three.js projects them', (facing, from) => {
    const { camera, frame } = seenFrom(from);
    const worldFromPose = new Float32Array(16);
    setFromAngles(worldFromPose, [0.1, 0.1, 0], [0.1, -0.2, 0.05]);
    const pose = createLabelPose(facing, 'room');
    expect(pose.set(worldFromPose, frame, CARD.widthPx, CARD.heightPx, SIZE_M, 0.15, box())).toBe(true);
    const matrices = createPageMatrices();
    matrices.set(frame, OVERLAY);
    const matrix = matrices.label(pose);
    for (const [x, y] of [
      [0, 0],
      [CARD.widthPx, 0],
      [0, CARD.heightPx],
      [CARD.widthPx, CARD.heightPx],
    ] as const) {
      const perPx = SIZE_M / FONT_PX;
      const corner = new Vector3((x - CARD.widthPx / 2) * perPx, (CARD.heightPx / 2 - y) * perPx, 0);
      corner.applyMatrix4(pose.worldFromLabel).project(camera);
      const [left = 0, top = 0] = drawnAt(matrix, x, y);
      expect(left).toBeCloseTo(((corner.x + 1) / 2) * OVERLAY.overlayWidthPx, 2);
      expect(top).toBeCloseTo(((1 - corner.y) / 2) * OVERLAY.overlayHeightPx, 2);
    }
  });

  test('the line leads from the pose to the label', () => {
    const { camera, frame } = seenFrom([0.5, 1, 3]);
    const worldFromPose = new Float32Array(16);
    setFromAngles(worldFromPose, [0.1, 0.1, 0], [0, 0, 0]);
    const pose = createLabelPose('viewer', 'room');
    pose.set(worldFromPose, frame, CARD.widthPx, CARD.heightPx, SIZE_M, 0.3, box());
    const matrices = createPageMatrices();
    matrices.set(frame, OVERLAY);
    const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = matrices.leader(pose) ?? [];
    for (const [t, y] of [
      [0, 0.1],
      [1, 0.4],
    ] as const) {
      const end = new Vector3(0.1, y, 0).project(camera);
      expect(a * t + c / 2 + e).toBeCloseTo(((end.x + 1) / 2) * OVERLAY.overlayWidthPx, 2);
      expect(b * t + d / 2 + f).toBeCloseTo(((1 - end.y) / 2) * OVERLAY.overlayHeightPx, 2);
    }
  });

  test('a label is not seen from behind, from beside the view, too near, or without a size', () => {
    const worldFromPose = new Float32Array(16);
    setFromAngles(worldFromPose, [0.1, 0.1, 0], [0, 0, 0]);
    const sees = (from: readonly [number, number, number], sizeM = SIZE_M, x = 0.1) => {
      worldFromPose[12] = x;
      return createLabelPose('pose', 'room').set(worldFromPose, seenFrom(from).frame, 320, 96, sizeM, 0, box());
    };
    expect(sees([0.5, 1, 3])).toBe(true);
    expect(sees([0.5, 1, -3])).toBe(false);
    expect(sees([0.5, 1, 3], SIZE_M, 9)).toBe(false);
    expect(sees([0.1, 0.1, 0.05])).toBe(false);
    expect(sees([0.5, 1, 3], 0)).toBe(false);
  });

  test('a size on the screen is the same at any distance', () => {
    const heights = [2, 8].map((z) => {
      const { frame } = seenFrom([0, 0, z]);
      const worldFromPose = new Float32Array(16);
      setFromAngles(worldFromPose, [0, 0, 0], [0, 0, 0]);
      const pose = createLabelPose('viewer', 'screen');
      pose.set(worldFromPose, frame, 320, FONT_PX, 0.05, 0, box());
      const matrices = createPageMatrices();
      matrices.set(frame, OVERLAY);
      const matrix = matrices.label(pose);
      const [x0 = 0, y0 = 0] = drawnAt(matrix, 160, 0);
      const [x1 = 0, y1 = 0] = drawnAt(matrix, 160, FONT_PX);
      return Math.hypot(x1 - x0, y1 - y0);
    });
    // 0.05 of 600 px; the label stands half its height above its pose, so its depth differs a little.
    for (const height of heights) expect(Math.abs(height - 30)).toBeLessThan(1);
  });
});
