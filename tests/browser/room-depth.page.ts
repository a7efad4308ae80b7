import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import { createRandom } from '../../export/runtime/random.ts';
import { createDepthReprojector } from '../../export/runtime/sessions/webxr/reproject-depth.ts';
import { createViewSources } from '../../export/runtime/sessions/webxr/view-sources.ts';
import type { AssetService } from '../../nodes/kit/assets.ts';
import depthViewSource from '../../nodes/layer/depth-view/depth-view.fs';
import { trackGl } from '../support/gl-leaks.ts';
import { createSensor, H, metersOf, type Params, samples, seen, stand, UPRIGHT, VIEW_H, VIEW_W, W } from './room-depth-kit.ts';
import { frame, MEASURED_DEPTH, pass, pixel, stand as playerFor, program, sourceOperation, texture, upset, view } from './runtime-kit.ts';
import { createGl, room } from './scenes-kit.ts';

/** The node without a player: depth goes in, depth comes out, and its numbers are read back. */

/** Two halves at 1 m and 3 m with holes of all sizes in each: one sample, a row, and a block that leaves only a rim. */
export function holes() {
  const isHole = (x: number, y: number): boolean => (x === 3 && y === 3) || y === 9 || (x > 18 && x < 31 && y > 10 && y < 17);
  const near = (x: number): boolean => x < W / 2;
  const pitted = samples((x, y) => (isHole(x, y) ? 0 : near(x) ? 1 : 3));
  const fill = (params: Params, meters: number[]) => {
    const { gl, step, node } = stand(params);
    const [depth] = step([seen(room(gl, W, H, meters))]);
    const found = metersOf(gl, depth);
    node.dispose();
    return { found, error: gl.getError() };
  };
  const filled = fill({}, pitted);
  return {
    error: filled.error,
    // What was known stays; what was not is what its side is, but for the samples by the step.
    changed: filled.found.filter((m, i) => pitted[i] !== 0 && Math.abs(m - (pitted[i] ?? 0)) > 1e-6).length,
    wrong: filled.found.filter(
      (m, i) => pitted[i] === 0 && Math.abs((i % W) + 0.5 - W / 2) > 5 && Math.abs(m - (near(i % W) ? 1 : 3)) > 0.02,
    ).length,
    punched: filled.found.filter((m) => m < 1 || m > 3).length,
    off: fill({ fillHoles: false }, pitted).found.filter((m) => m === 0).length,
    holes: pitted.filter((m) => m === 0).length,
    unknown: new Set(
      fill(
        {},
        samples(() => 0),
      ).found,
    ),
    unknownIsEmpty: fill(
      {},
      samples(() => 0),
    ).found.every((m) => m === 0),
  };
}

/** Hole x 8–23: a window whose frame is 1.8 m away; below it, a balcony at 3 m; the sky above is cut off by the image, or by a lintel. */
export function windows() {
  const isGlass = (x: number): boolean => x >= 8 && x < 24;
  const cases = {
    // Middle of the glass. The balcony is farther than the frame.
    balcony: samples((x, y) => (y < 4 ? 3 : isGlass(x) ? 0 : 1.8)),
    // Glass that the image cuts off below and above: nothing says how far it is.
    sky: samples((x) => (isGlass(x) ? 0 : 1.8)),
    // Glass in a wall is filled as if it were the wall, which is seen obliquely.
    wall: samples((x, y) => (isGlass(x) && y > 3 && y < 15 ? 0 : 1 / (0.5 + 0.01 * x))),
    // One sample of the frame is a flying pixel, half way to the balcony.
    flying: samples((x, y) => (y < 4 ? 3 : x === 7 ? 2.4 : isGlass(x) ? 0 : 1.8)),
  };
  return Object.fromEntries(
    Object.entries(cases).map(([name, meters]) => {
      const { gl, step, node } = stand({});
      const found = metersOf(gl, step([seen(room(gl, W, H, meters))])[0]);
      node.dispose();
      return [name, { middle: found[9 * W + 15], error: gl.getError() }];
    }),
  );
}

/** Gray along row 9 of a floor-like slope whose right part is 1 m farther and has an unfilled hole; and of an even and a noisy wall. */
export function confidences() {
  const rate = (meters: number[], params: Params = {}) => {
    const { gl, step, node, confidence } = stand(params);
    step([seen(room(gl, W, H, meters))]);
    const view = confidence[0];
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, view?.texture ?? null, 0);
    const rgba = new Uint8Array(W * H * 4);
    gl.readPixels(0, 0, W, H, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
    gl.deleteFramebuffer(framebuffer);
    node.dispose();
    if (gl.getError() !== 0) throw new Error('GL has an error.');
    return { gray: Array.from({ length: W * H }, (_, i) => rgba[i * 4] ?? 0), size: [view?.widthPx, view?.heightPx] };
  };
  const noise = createNoise();
  const slope = (x: number, y: number): number => 1 + 0.03 * y + (x < 12 ? 0 : 1);
  const holed = samples((x, y) => (x > 22 && x < 26 && y > 6 && y < 12 ? 0 : slope(x, y)));
  const filled = rate(holed);
  const mean = (gray: readonly number[]): number => gray.reduce((a, b) => a + b, 0) / gray.length;
  return {
    size: filled.size,
    row: [4, 8, 10, 11, 12, 13, 17, 24, 30].map((x) => filled.gray[9 * W + x]),
    open: rate(holed, { fillHoles: false }).gray[9 * W + 24],
    calm: mean(rate(samples(() => 2 + noise())).gray),
    noisy: mean(rate(samples(() => 2 + 4 * noise())).gray),
    plain: rate(holed, { filter: 'nearest', fillHoles: false }).gray[9 * W + 4],
  };
}

const SIGMA_M = 0.01;

function createNoise(): () => number {
  const { next } = createRandom(7, 'noise');
  // Box and Muller.
  return () => SIGMA_M * Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());
}

function spread(values: readonly number[]): number {
  const mean = values.reduce((a, b) => a + b, 0) / values.length;
  return Math.sqrt(values.reduce((sum, v) => sum + (v - mean) ** 2, 0) / values.length);
}

/** A noisy wall at 2 m, before which a slab at 1 m goes from left to right, a sample a frame. */
export function moving(smoothingS: number) {
  const { gl, step, node } = stand({ smoothingS, fillHoles: false });
  const sensor = createSensor(gl);
  const noise = createNoise();
  let trail = 0;
  let missing = 0;
  let last: number[] = [];
  for (let t = 0; t < 60; t++) {
    const isSlab = (x: number): boolean => x >= t - 20 && x < t - 12;
    const [depth] = step([seen(sensor(samples((x) => (isSlab(x) ? 1 : 2) + noise())))]);
    last = metersOf(gl, depth);
    last.forEach((m, i) => {
      if (!isSlab(i % W) && m < 1.9) trail++;
      if (isSlab(i % W) && m > 1.1) missing++;
    });
  }
  node.dispose();
  return { trail, missing, spreadM: spread(last), error: gl.getError() };
}

/** The eye steps back from a wall, 2 mm a frame, and turns: what was measured before is somewhere else by now. */
export function walking(smoothingS: number) {
  // Turned a quarter and cut, as a phone's sensor is.
  const turned = [0, 0.8, 0, -0.9, 0, 0, 0.95, 0.1, 1];
  const { gl, step, node } = stand({ smoothingS, fillHoles: false });
  const sensor = createSensor(gl, turned);
  const noise = createNoise();
  const errors: number[] = [];
  for (let t = 0; t < 40; t++) {
    const z = 2 + t * 0.002;
    const yaw = t * 0.004;
    const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
    const worldFromView = Float32Array.of(c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, z, 1);
    const viewFromWorld = Float32Array.of(c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, s * z, 0, -c * z, 1);
    // Samples → view UV: the inverse of the turn above; the projection sees 90 degrees each way.
    const truth = samples((_x, y) => {
      const viewU = ((y + 0.5) / H - 0.1) / 0.8;
      const across = viewU * 2 - 1;
      // The wall is z = 0 of the world: eye z minus m (c + s across) is 0.
      return z / (c + s * across);
    });
    const [depth] = step([seen(sensor(truth.map((m) => m + noise())), { worldFromView, viewFromWorld })]);
    if (t < 20) continue;
    const found = metersOf(gl, depth);
    errors.push(...found.map((m, i) => m - (truth[i] ?? 0)));
  }
  node.dispose();
  const mean = errors.reduce((a, b) => a + b, 0) / errors.length;
  return { mean, spreadM: spread(errors), error: gl.getError() };
}

/**
 * A thing at 1 m before a wall at 3 m. Its right edge is at 0.45 of the view by the camera, between two samples of the sensor;
 * where the depth changes from one to the other, and over how many pixels.
 */
export function edges(withCamera: boolean) {
  const { gl, step, node } = stand({ filter: 'edge-aware' });
  const edge = 0.45;
  const sensed = samples((x) => ((x + 0.5) / W < edge ? 1 : 3));
  const picture = Array.from({ length: VIEW_W * VIEW_H }, (_, i) => ((i % VIEW_W) + 0.5) / VIEW_W < edge).flatMap((isThing) =>
    isThing ? [180, 60, 30, 255] : [40, 70, 160, 255],
  );
  const cameraImage = withCamera
    ? { texture: texture(gl, VIEW_W, VIEW_H, picture), widthPx: VIEW_W, heightPx: VIEW_H, uvFromViewUv: Float32Array.from(UPRIGHT) }
    : null;
  const [depth] = step([seen(room(gl, W, H, sensed), { cameraImage })]);
  const found = metersOf(gl, depth);
  const row = found.slice(VIEW_W * 30, VIEW_W * 31);
  node.dispose();
  return {
    size: [depth?.widthPx, depth?.heightPx],
    border: row.findIndex((m) => m > 2),
    between: row.filter((m) => m > 1.05 && m < 2.95).length,
    ends: [row[2], row[VIEW_W - 3]],
    error: gl.getError(),
  };
}

/** The sizes of what “By sensor” outputs for sensors of so many samples per side. */
export function bySensor(sides: readonly number[]) {
  const { gl, step, node } = stand({ filter: 'by-sensor' });
  const sensed = sides.map((side) => room(gl, side, 2, new Array<number>(2 * side).fill(2)));
  const sizes = sensed.map((measured) => {
    const [depth] = step([seen(measured)]);
    return [depth?.widthPx, depth?.heightPx];
  });
  node.dispose();
  return { sizes, error: gl.getError() };
}

/** Black, gray, white and nothing, from the left, at 1 m to 4 m; the picture is wider than the view. */
export function painted(shades: string, fillHoles: boolean) {
  const gl = createGl();
  const row = [0, 0, 0, 255, 0, 0, 0, 255, 128, 128, 128, 255, 255, 255, 255, 255, 0, 0, 0, 0, 255, 255, 255, 255];
  const asset = { texture: texture(gl, 6, 1, row), widthPx: 6, heightPx: 1 };
  const handle = { kind: 'image', value: asset, settled: Promise.resolve(), release: () => {} };
  const assets = { image: () => handle } as unknown as AssetService;
  const params = { source: 'picture', picture: 'painted', shades, nearM: 1, farM: 4, fillHoles, filter: 'nearest' };
  const { step, node } = stand(params, { gl, assets });
  const [left, right] = step([seen(null), seen(null)]);
  const result = {
    meters: metersOf(gl, left).map((m) => Math.round(m * 1000) / 1000),
    uv: [...(right?.uvFromViewUv ?? [])].map((v) => Math.round(v * 1000) / 1000),
    error: gl.getError(),
  };
  node.dispose();
  return result;
}

/** What a hundred frames of two views make and leave behind. */
export function leftBehind() {
  const gl = createGl();
  const sensor = createSensor(gl);
  const leaks = trackGl(gl);
  const { step, node } = stand({ filter: 'edge-aware', smoothingS: 0.2 }, { gl });
  const counts: Readonly<Record<string, number>>[] = [];
  for (let t = 0; t < 20; t++) {
    const depth = sensor(samples(() => 2));
    step([seen(depth), seen(depth)]);
    counts.push(leaks.alive());
  }
  node.dispose();
  const flat = counts.every((count) => JSON.stringify(count) === JSON.stringify(counts[0]));
  return { flat, left: leaks.report(), error: gl.getError() };
}

/** Colors of the depth view over a room of 0.5, 2.25, 4 and no meters from the left, and how much of its scale is ink. */
export async function depthView() {
  const shader = readIsf(depthViewSource, 'depth-view.fs').output;
  const [linked] = (shader && linkIsf(shader, { node: 'seen' }).output) ?? [];
  if (!linked) throw new Error('The shader cannot be linked.');
  const numbers = [0.5, 4, 1, 0];
  const slotOf: Record<string, number> = { nearM: 0, farM: 1, opacity: 2, legend: 3 };
  const shows = program({
    slots: { numbers, texts: [], slots: numbers.map((_, offset) => ({ type: 'number' as const, offset })), params: { 'seen.legend': 3 } },
    resources: [{ id: 'room', kind: 'room-depth' }],
    shaders: [linked.shader],
    operations: [
      sourceOperation('world/depth', 'depth', 'room'),
      pass('seen', 0, 'screen', {
        samplers: linked.samplers.map(({ name }) => ({ name, source: { kind: 'room-depth', resource: 'room' }, fit: 'none' })),
        uniforms: linked.uniforms.map(({ name, type, source }) => ({
          name,
          type,
          source: 'builtin' in source ? source : { slot: 'param' in source ? (slotOf[source.param] ?? -1) : -1 },
        })),
      }),
    ],
  });
  const gl = createGl(320, 240);
  const { player } = await playerFor(shows, { gl, modules: { 'world/depth': MEASURED_DEPTH } });
  const depth = room(gl, 4, 1, [0.5, 2.25, 4, 0]);
  const draw = (index: number): void => {
    player.draw(frame(index, [view(0, 0, 320, 240, { depth })], { framebufferWidthPx: 320, framebufferHeightPx: 240 }));
  };
  draw(0);
  const colors = [40, 120, 200, 280].map((x) => pixel(gl, x, 120));
  const ink = (): number => {
    let white = 0;
    for (let y = 40; y < 200; y++) for (let x = 22; x < 70; x++) if (pixel(gl, x, y).every((value) => value === 255)) white++;
    return white;
  };
  const before = ink();
  player.setParam('seen', 'legend', 1);
  draw(1);
  const result = { colors, ink: [before, ink()], bar: [pixel(gl, 15, 50), pixel(gl, 15, 190)], error: gl.getError() };
  player.dispose();
  return result;
}

/** The wall is 3 m away, and before it a square of 0.8 m at 1.5 m; rays by their slopes from a place on the x–z plane. */
function hitM(x: number, z: number, dx: number, dy: number, dz: number): number {
  for (const [planeZ, half] of [
    [-1.5, 0.4],
    [-3, 99],
  ] as const) {
    const t = (planeZ - z) / dz;
    if (t > 0 && Math.abs(x + t * dx) < half && Math.abs(t * dy) < half) return t;
  }
  return 0;
}

/** A depth camera 10 cm to the right, turned by 0.15 to the left, its picture turned a quarter, seen from the view in the middle. */
export function reprojected() {
  const gl = createGl();
  const reprojector = createDepthReprojector(gl);
  if (!reprojector) throw new Error('The GPU draws no floats.');
  const [eyeX, yaw, columns, rows] = [0.1, 0.15, 96, 128];
  const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
  const worldFromDepth = Float32Array.of(c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, eyeX, 0, 0, 1);
  // 80 degrees wide and 66 high.
  const [tanX, tanY] = [0.84, 0.65];
  const clipFromDepth = Float32Array.of(1 / tanX, 0, 0, 0, 0, 1 / tanY, 0, 0, 0, 0, -1, -1, 0, 0, -0.1, 0);
  // u = v of the view, v = 1 - u of the view.
  const turned = [0, -1, 0, 1, 0, 0, 0, 1, 1];
  const meters = Array.from({ length: columns * rows }, (_, i) => {
    const viewV = ((i % columns) + 0.5) / columns;
    const viewU = 1 - (Math.floor(i / columns) + 0.5) / rows;
    const [x, y] = [(viewU * 2 - 1) * tanX, (viewV * 2 - 1) * tanY];
    return hitM(eyeX, 0, c * x - s, y, -s * x - c);
  });
  const from = room(gl, columns, rows, meters, turned);
  upset(gl);
  const wanted = view(0, 0, VIEW_W, VIEW_H);
  const depth = reprojector.reproject(from, { worldFromDepth, clipFromDepth }, wanted);
  const found = metersOf(gl, depth);
  const tally = { right: 0, wrong: 0, unknown: 0, between: 0 };
  found.forEach((m, i) => {
    // A view of 90 degrees each way.
    const x = (((i % columns) + 0.5) / columns) * 2 - 1;
    const y = ((Math.floor(i / columns) + 0.5) / rows) * 2 - 1;
    const truth = hitM(0, 0, x, y, -1);
    if (m === 0) tally.unknown++;
    else if (Math.abs(m - truth) < 0.01) tally.right++;
    else if (m > 1.6 && m < 2.9) tally.between++;
    else tally.wrong++;
  });
  reprojector.dispose();
  return { ...tally, all: found.length, error: gl.getError() };
}

/** Programs that it takes to bring depth of one sample to the view, by the lens that it was measured through. */
export function lenses() {
  const session = { depthUsage: 'cpu-optimized', depthDataFormat: 'float32' } as unknown as XRSession;
  const wanted = view(0, 0, VIEW_W, VIEW_H);
  const programsFor = (change: (projection: Float32Array) => void): number => {
    const gl = createGl();
    const leaks = trackGl(gl);
    const sources = createViewSources(gl, session, null, true);
    const projectionMatrix = wanted.clipFromView.slice();
    change(projectionMatrix);
    const info = {
      width: 1,
      height: 1,
      data: Float32Array.of(2).buffer,
      rawValueToMeters: 1,
      normDepthBufferFromNormView: { matrix: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) },
      projectionMatrix,
    };
    sources.depth({ getDepthInformation: () => info } as unknown as XRFrame, {} as XRView, 0, wanted);
    const programs = leaks.alive().Program ?? 0;
    sources.dispose();
    return programs;
  };
  return {
    same: programsFor(() => {}),
    otherPlanes: programsFor((m) => m.set([-1, -1, 0, 0, -0.2, 0], 10)),
    wider: programsFor((m) => m.set([(m[0] ?? 1) * 0.9])),
    shifted: programsFor((m) => m.set([0.1], 9)),
  };
}

/** A GPU that can draw no floats. */
export function withoutFloats() {
  const gl = createGl();
  gl.getExtension('EXT_color_buffer_float');
  Object.assign(gl, { getExtension: () => null });
  const { step, node } = stand({ filter: 'edge-aware', smoothingS: 0.2 }, { gl });
  const [depth] = step([
    seen(
      room(
        gl,
        W,
        H,
        samples((x) => x + 1),
      ),
    ),
  ]);
  const found = metersOf(gl, depth);
  node.dispose();
  return { first: found.slice(0, 3), interpolate: depth?.interpolate };
}
