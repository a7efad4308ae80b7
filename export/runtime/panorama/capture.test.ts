import { expect, test } from '@jest/globals';
import { uprightPose } from '../../../nodes/kit/panorama/capture-targets.ts';
import type { CameraImage, SessionFrame, ViewFrame } from '../../../nodes/kit/session.ts';
import { createPanoramaCapture, type PanoramaCapture } from './capture.ts';

/** 66° × 50°: 34 targets leave no holes. */
const LENS = new Float32Array([1.54, 0, 0, 0, 0, 2.14, 0, 0, 0, 0, -1, -1, 0, 0, -0.1, 0]);
const FRAME_S = 1 / 30;

/** A visitor with a camera in the hand. */
function visitor(options: { readonly lens?: Float32Array; readonly camera?: boolean; readonly holdS?: number } = {}) {
  const { lens = LENS, camera = true, holdS = 0.4 } = options;
  const sizes: [number, number][] = [];
  const view = {
    clipFromView: lens,
    worldFromView: uprightPose([0, 0, -1]),
    cameraImage: camera ? ({} as CameraImage) : null,
  };
  const frame = { timeS: 0, viewCount: 1, views: [view as unknown as ViewFrame] };
  const capture: PanoramaCapture = createPanoramaCapture({
    holdS,
    widthPx: 1024,
    read: ({ clipFromView, worldFromView }, widthPx, heightPx) => {
      sizes.push([widthPx, heightPx]);
      return { widthPx, heightPx, data: new Uint8Array(0), clipFromView: clipFromView.slice(), worldFromView: worldFromView.slice() };
    },
  });
  const step = () => {
    frame.timeS += FRAME_S;
    capture.update(frame as unknown as SessionFrame);
  };
  return {
    capture,
    sizes,
    step,
    look: (direction: readonly [number, number, number], at: readonly number[] = [0, 0, 0]) => {
      const length = Math.hypot(...direction);
      view.worldFromView = uprightPose(direction.map((value) => value / length) as [number, number, number]);
      view.worldFromView.set(at, 12);
    },
    hold: (seconds: number) => {
      for (let i = 0; i < seconds / FRAME_S; i++) step();
    },
  };
}

test('takes a photo where the camera points at a target and holds still, and not while it moves', () => {
  const { capture, look, hold, step } = visitor();
  look([0.02, 0, -1]);
  hold(0.3);
  expect(capture.shots).toHaveLength(0);
  expect(capture.held).toBeGreaterThan(0.5);
  // It moves past the target.
  for (let i = 0; i < 30; i++) {
    look([Math.sin(i) * 0.05, 0, -1]);
    step();
  }
  expect(capture.shots).toHaveLength(0);
  look([0, 0, -1]);
  hold(0.6);
  expect(capture.shots).toHaveLength(1);
  expect(capture.targets.filter(({ taken }) => taken)).toHaveLength(1);
  // Still there: the target is green, and takes no second photo.
  hold(2);
  expect(capture.shots).toHaveLength(1);
});

test('is complete after 34 photos in any order, without holes', () => {
  const { capture, look, hold, sizes, step } = visitor();
  step();
  expect(capture.targets).toHaveLength(34);
  for (const { direction } of [...capture.targets].reverse()) {
    look(direction);
    hold(0.6);
  }
  expect(capture.state).toBe('complete');
  expect(capture.shots).toHaveLength(34);
  // One and a half pixels for each of the panorama: 66° of 1024 pixels for 360°.
  expect(sizes[0]?.[0]).toBeCloseTo((66 / 360) * 1024 * 1.5, -1);
});

test('adds targets where the photos leave holes, because the visitor did not point well', () => {
  const narrow = new Float32Array(LENS);
  narrow[0] = 2.2;
  narrow[5] = 2.6;
  const { capture, look, hold, step } = visitor({ lens: narrow });
  step();
  const planned = capture.targets.length;
  expect(planned).toBeGreaterThan(34);
  for (const [i, { direction }] of [...capture.targets].entries()) {
    const [x, y, z] = direction;
    look([x, y + (i % 2 === 0 ? 0.05 : -0.05), z + 0.02]);
    hold(0.6);
  }
  for (let i = 0; i < 60 && capture.state === 'taking' && capture.next; i++) {
    look(capture.next.direction);
    hold(0.6);
  }
  expect(capture.state).toBe('complete');
  expect(capture.shots.length).toBeGreaterThanOrEqual(planned);
});

test('waits while the visitor has left the place', () => {
  const { capture, look, hold } = visitor();
  look([0, 0, -1]);
  hold(0.6);
  look(capture.next?.direction ?? [0, 0, 0], [1, 0, 0]);
  hold(1);
  expect(capture.isAway).toBe(true);
  expect(capture.shots).toHaveLength(1);
});

test('says that a session gives no image, after a while', () => {
  const { capture, hold } = visitor({ camera: false });
  hold(1);
  expect(capture.state).toBe('waiting');
  hold(3);
  expect(capture.state).toBe('blind');
});

test('uses the newest lens for all photos, because it is estimated while the device turns', () => {
  const lens = LENS.slice();
  const { capture, look, hold } = visitor({ lens });
  look([0, 0, -1]);
  hold(0.6);
  lens[0] = 1.7;
  lens[5] = (2.14 / 1.54) * 1.7;
  hold(0.1);
  expect(capture.shots[0]?.clipFromView[0]).toBeCloseTo(1.54, 5);
  expect(capture.result().shots[0]?.clipFromView[0]).toBeCloseTo(1.7, 5);
});

test('takes over photos of an earlier session, whose targets are green', () => {
  const first = visitor();
  first.look([0, 0, -1]);
  first.hold(0.6);
  const second = visitor();
  second.capture.adopt(first.capture.result().shots, 0);
  second.step();
  expect(second.capture.targets.filter(({ taken }) => taken)).toHaveLength(1);
  expect(second.capture.result().shots).toHaveLength(1);
  // The same photo in a session whose heading differs by a radian.
  const [photo] = first.capture.result().shots;
  const turned = { ...photo, worldFromView: uprightPose([-Math.sin(1), 0, -Math.cos(1)]) } as typeof photo & object;
  second.capture.adopt([turned], 1);
  second.step();
  expect(second.capture.targets.filter(({ taken }) => taken)).toHaveLength(1);
  second.capture.restart();
  second.step();
  expect(second.capture.targets.some(({ taken }) => taken)).toBe(false);
});
