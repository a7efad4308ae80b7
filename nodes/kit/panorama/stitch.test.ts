import { describe, expect, test } from '@jest/globals';
import { linearFromSrgb, srgbFromLinear } from '../color-math.ts';
import { captureTargets, coverageOf, targetsForHoles, uprightPose } from './capture-targets.ts';
import { createHeadingSearch, isCertain } from './match-heading.ts';
import { headingOf, type PanoramaShot, setPanoramaPose } from './shot.ts';
import { stitch } from './stitch.ts';

/** A projection without far plane; fields of view in degrees. */
function lens(acrossDeg: number, upDeg: number): Float32Array {
  const [across, up] = [acrossDeg, upDeg].map((deg) => 1 / Math.tan((deg / 360) * Math.PI)) as [number, number];
  return new Float32Array([across, 0, 0, 0, 0, up, 0, 0, 0, 0, -1, -1, 0, 0, -0.1, 0]);
}

/** Linear radiance of a smooth room in each direction; brighter on one side than on the other. */
function room(x: number, y: number, z: number): [number, number, number] {
  const checks = 0.5 + 0.4 * Math.sin(5 * x + 2 * y) * Math.cos(4 * z - y);
  return [0.5 * checks * (1 + 0.4 * x), 0.4 * checks * (1 + 0.3 * y), 0.35 * checks * (1 - 0.3 * z) + 0.05];
}

/** What a camera sees of the room. */
function photograph(worldFromView: Float32Array, clipFromView: Float32Array, exposure = 1, turnRad = 0, light = room): PanoramaShot {
  const [widthPx, heightPx] = [64, 64];
  const data = new Uint8Array(widthPx * heightPx * 4);
  const m = worldFromView;
  for (let row = 0; row < heightPx; row++) {
    for (let column = 0; column < widthPx; column++) {
      const x = (((column + 0.5) / widthPx) * 2 - 1) / (clipFromView[0] ?? 1);
      const y = (((row + 0.5) / heightPx) * 2 - 1) / (clipFromView[5] ?? 1);
      const world = [0, 1, 2].map((i) => (m[i] ?? 0) * x + (m[4 + i] ?? 0) * y - (m[8 + i] ?? 0)) as [number, number, number];
      const length = Math.hypot(...world);
      const [dx, dy, dz] = world.map((value) => value / length) as [number, number, number];
      // The room is turned counterclockwise by the angle.
      const [cos, sin] = [Math.cos(turnRad), Math.sin(turnRad)];
      const color = light(dx * cos - dz * sin, dy, dx * sin + dz * cos).map((value) => 255 * srgbFromLinear(Math.min(1, value * exposure)));
      data.set([...color.map(Math.round), 255], (row * widthPx + column) * 4);
    }
  }
  return { widthPx, heightPx, data, clipFromView, worldFromView };
}

function whole<T>(slices: Generator<undefined, T>): T {
  for (;;) {
    const { done, value } = slices.next();
    if (done) return value;
  }
}

/** Peak signal to noise ratio against the room, in decibels, after the exposure that suits best. */
function decibels({ data, widthPx, heightPx }: ReturnType<typeof makePanorama>, seenOnly = false): number {
  const truth = new Float64Array(data.length);
  let product = 0;
  let square = 0;
  for (let y = 0; y < heightPx; y++) {
    for (let x = 0; x < widthPx; x++) {
      const longitude = ((x + 0.5) / widthPx) * 2 * Math.PI - Math.PI;
      const elevation = Math.PI / 2 - ((y + 0.5) / heightPx) * Math.PI;
      const level = Math.cos(elevation);
      const color = room(level * Math.sin(longitude), Math.sin(elevation), -level * Math.cos(longitude));
      const at = (y * widthPx + x) * 4;
      for (let c = 0; c < 3; c++) {
        truth[at + c] = color[c] ?? 0;
        const seen = linearFromSrgb((data[at + c] ?? 0) / 255);
        product += seen * (truth[at + c] ?? 0);
        square += seen * seen;
      }
    }
  }
  const gain = product / square;
  let errors = 0;
  let count = 0;
  for (let i = 0; i < data.length; i++) {
    if (i % 4 === 3 || (seenOnly && data[i - (i % 4) + 3] === 0)) continue;
    const seen = 255 * srgbFromLinear(Math.min(1, gain * linearFromSrgb((data[i] ?? 0) / 255)));
    errors += (seen - 255 * srgbFromLinear(truth[i] ?? 0)) ** 2;
    count++;
  }
  return 10 * Math.log10((255 * 255 * count) / errors);
}

function makePanorama(shots: readonly PanoramaShot[]) {
  return whole(stitch(shots, 128));
}

const WIDE = lens(66, 50);

describe('targets', () => {
  test('are 34 for the camera of a phone that is held across, and leave no holes', () => {
    const targets = captureTargets(WIDE);
    expect(targets).toHaveLength(34);
    const { seenPart, overlapPart } = coverageOf(targets.map((target) => ({ clipFromView: WIDE, worldFromView: uprightPose(target) })));
    expect(seenPart).toBeGreaterThan(0.998);
    expect(overlapPart).toBeGreaterThan(0.5);
  });

  test('are more for a lens that leaves holes between 34, until there are none', () => {
    const narrow = lens(32, 56);
    const targets = captureTargets(narrow);
    expect(targets.length).toBeGreaterThan(34);
    const { seenPart } = coverageOf(targets.map((target) => ({ clipFromView: narrow, worldFromView: uprightPose(target) })));
    expect(seenPart).toBeGreaterThan(0.998);
  });

  test('missed photos leave a hole, for which a few targets are enough', () => {
    const shots = captureTargets(WIDE).map((target) => ({ clipFromView: WIDE, worldFromView: uprightPose(target) }));
    // The third column of a pose points back.
    const missed = shots.filter(({ worldFromView }) => (worldFromView[10] ?? 0) < 0.7);
    const targets = targetsForHoles(missed, WIDE, 60);
    expect(targets.length).toBeGreaterThan(0);
    expect(targets.length).toBeLessThan(6);
    expect(targets[0]?.[2]).toBeLessThan(-0.8);
    const { seenPart } = coverageOf([...missed, ...targets.map((target) => ({ clipFromView: WIDE, worldFromView: uprightPose(target) }))]);
    expect(seenPart).toBeGreaterThan(0.997);
  });
});

describe('a panorama of 34 photos', () => {
  const poses = captureTargets(WIDE).map(uprightPose);

  test('shows the room', () => {
    const panorama = makePanorama(poses.map((pose) => photograph(pose, WIDE)));
    expect(decibels(panorama)).toBeGreaterThan(40);
    expect(panorama.holesPart).toBeLessThan(0.002);
    expect(panorama.evened).toBe(true);
  });

  test('whose exposure changed by up to a stop shows it as well', () => {
    const shots = poses.map((pose, i) => photograph(pose, WIDE, 2 ** Math.sin(7 * i)));
    expect(decibels(makePanorama(shots))).toBeGreaterThan(36);
    expect(decibels(whole(stitch([...shots].reverse(), 128)))).toBeGreaterThan(36);
  });

  test('keeps a lamp white, though its photo is darkened', () => {
    const lamp = (x: number, y: number, z: number) => (z < -0.95 ? ([4, 4, 4] as [number, number, number]) : room(x, y, z));
    const shots = poses.map((pose, i) => photograph(pose, WIDE, i % 2 === 0 ? 1 : 1.6, 0, lamp));
    const { data } = makePanorama(shots);
    const isWhite = (at: number) => Math.min(data[at] ?? 0, data[at + 1] ?? 0, data[at + 2] ?? 0) >= 250;
    const whites = Array.from({ length: data.length / 4 }, (_, i) => 4 * i).filter(isWhite).length;
    // The cone takes 2.5 % of the sphere, of 128 × 64 pixels, in the middle of the map.
    expect(whites).toBeGreaterThan(80);
    expect(whites).toBeLessThan(200);
  });

  test('with little overlap keeps the exposure of each, fills the holes and marks them', () => {
    const shots = [0, 9, 18, 27].map((i) => photograph(poses[i] as Float32Array, WIDE, i === 0 ? 0.5 : 1));
    const panorama = makePanorama(shots);
    expect(panorama.evened).toBe(false);
    expect(panorama.overlapPart).toBeLessThan(0.25);
    let holes = 0;
    let black = 0;
    for (let y = 0; y < panorama.heightPx; y++) {
      for (let x = 0; x < panorama.widthPx; x++) {
        const at = (y * panorama.widthPx + x) * 4;
        if (panorama.data[at + 3] === 0) holes += Math.sin(((y + 0.5) / panorama.heightPx) * Math.PI);
        if ((panorama.data[at] ?? 0) + (panorama.data[at + 1] ?? 0) + (panorama.data[at + 2] ?? 0) < 30) black++;
      }
    }
    expect((holes * Math.PI) / 2 / panorama.widthPx / panorama.heightPx).toBeCloseTo(panorama.holesPart, 1);
    expect(panorama.holesPart).toBeGreaterThan(0.5);
    expect(black).toBe(0);
    // The dark photo stays as dark as it was taken: straight ahead.
    const center = ((panorama.heightPx / 2) * panorama.widthPx + panorama.widthPx / 2) * 4;
    expect(linearFromSrgb((panorama.data[center] ?? 0) / 255) / room(0, 0, -1)[0]).toBeCloseTo(0.5, 1);
  });

  test('no photo at all gives a gray nothing, all of it a hole', () => {
    const panorama = makePanorama([]);
    expect(panorama.holesPart).toBe(1);
    expect(panorama.data.every((value) => value === 0)).toBe(true);
  });
});

describe('heading', () => {
  const panorama = makePanorama(captureTargets(WIDE).map((target) => photograph(uprightPose(target), WIDE)));

  test.each([0, 0.7, -2.4, 3.1])('of a room that is turned by %d rad is found from two photos within half a degree', (turnRad) => {
    const search = createHeadingSearch(panorama);
    search.add(photograph(uprightPose([0.3, 0.1, -0.95]), WIDE, 0.7, turnRad));
    const match = search.add(photograph(uprightPose([-0.9, -0.2, -0.4]), WIDE, 1.3, turnRad));
    expect(isCertain(match)).toBe(true);
    const error = Math.atan2(Math.sin(match.headingRad - turnRad), Math.cos(match.headingRad - turnRad));
    expect(Math.abs(error)).toBeLessThan(Math.PI / 360);
  });

  test('is uncertain for a white wall', () => {
    const shot = photograph(uprightPose([0, 0, -1]), WIDE);
    expect(isCertain(createHeadingSearch(panorama).add({ ...shot, data: shot.data.map(() => 255) }))).toBe(false);
  });

  test('is read from a pose as it was written', () => {
    const pose = new Float32Array(16);
    setPanoramaPose(pose, 1.2, [3, 4, 5]);
    expect(headingOf(pose)).toBeCloseTo(1.2, 6);
    expect([...pose.slice(12, 15)]).toEqual([3, 4, 5]);
  });
});
