import { pixelAt, type RgbaImage } from '../support/image.ts';
import { BOX_HALF_M, BOX_HEIGHT_M, FLOOR_HALF_M, SHADOW_STRENGTH } from '../xr/room-box.ts';
import type { XrPage } from '../xr/xr-page.ts';

// What pixels of `roomBox` in a scanned room have to show, worked out from the rays alone: what the room has there (cast at the scan's
// triangles), the box, the floor, and the way to the light.

export type Vector = readonly [number, number, number];

/** Where the floor of each room is free around the box: x and z. */
export type Place = readonly [number, number];

export const WIDTH = 320;
export const HEIGHT = 240;
/** Of scanned rooms, as the emulated device estimates it. */
const TOWARDS_LIGHT: Vector = [0.36, 0.8, 0.48];
/** What is nearer to an edge than this is left out: outlines of the buffer, the softness of the shadow, bumps of the scan. */
const MARGIN_M = 0.06;
const MARGIN_PX = 2;
const STEP_PX = 9;

export interface Eye {
  readonly origin: Vector;
  /** Column-major 3×3 of its axes, and the projection. */
  readonly worldFromView: readonly number[];
  readonly clipFromView: readonly number[];
  readonly left: number;
  readonly width: number;
}

/** Through the middle of a pixel; it advances 1 m along the view's axis. */
function rayOf({ worldFromView: m, clipFromView: p, left, width }: Eye, x: number, y: number): Vector {
  const right = ((2 * (x + 0.5 - left)) / width - 1 + (p[8] ?? 0)) / (p[0] ?? 1);
  const up = (1 - (2 * (y + 0.5)) / HEIGHT + (p[9] ?? 0)) / (p[5] ?? 1);
  const along = (row: number) => (m[row] ?? 0) * right + (m[row + 4] ?? 0) * up - (m[row + 8] ?? 0);
  return [along(0), along(1), along(2)];
}

/** Where the ray enters the box made larger by `growM`, in the ray's own lengths; infinite where it passes. Kay and Kajiya 1986. */
function boxAlong([px, pz]: Place, origin: Vector, ray: Vector, growM: number): number {
  const min: Vector = [px - BOX_HALF_M, 0, pz - BOX_HALF_M];
  const max: Vector = [px + BOX_HALF_M, BOX_HEIGHT_M, pz + BOX_HALF_M];
  let enter = 0;
  let leave = Number.POSITIVE_INFINITY;
  for (const axis of [0, 1, 2] as const) {
    const a = (min[axis] - growM - origin[axis]) / ray[axis];
    const b = (max[axis] + growM - origin[axis]) / ray[axis];
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
  }
  return enter < leave ? enter : Number.POSITIVE_INFINITY;
}

type Expected = 'box' | 'shadow' | 'lit floor' | 'hidden' | 'room' | null;

/** What a pixel has to show, or null where it cannot be said. */
function expectedAt(place: Place, eye: Eye, ray: Vector, roomAlong: number): Expected {
  const [small, box, large] = [-MARGIN_M, 0, MARGIN_M].map((grow) => boxAlong(place, eye.origin, ray, grow)) as [number, number, number];
  const length = Math.hypot(...ray);
  const margin = MARGIN_M / length;
  if (Number.isFinite(small)) {
    if (roomAlong < large - margin) return 'hidden';
    return roomAlong > box + margin ? 'box' : null;
  }
  if (Number.isFinite(large)) return null;
  const floor = ray[1] < -0.05 ? -eye.origin[1] / ray[1] : Number.POSITIVE_INFINITY;
  const at: Vector = [eye.origin[0] + ray[0] * floor, 0, eye.origin[2] + ray[2] * floor];
  const outside = Math.max(Math.abs(at[0]), Math.abs(at[2])) - FLOOR_HALF_M;
  if (!Number.isFinite(floor) || outside > MARGIN_M) return 'room';
  if (outside > -MARGIN_M) return null;
  // Depth is off by the tolerance of the shadow's clipping, 10 cm along the view's axis.
  if (roomAlong < floor - 0.1 - margin) return 'hidden';
  if (Math.abs(roomAlong - floor) > 0.1 - margin) return null;
  const shadowed = [-MARGIN_M, MARGIN_M].map((grow) => Number.isFinite(boxAlong(place, at, TOWARDS_LIGHT, grow)));
  if (shadowed[0]) return 'shadow';
  return shadowed[1] ? null : 'lit floor';
}

function isAsExpected(expected: Exclude<Expected, null>, [red, green, blue, alpha]: readonly [number, number, number, number]): boolean {
  switch (expected) {
    case 'box':
      return alpha === 255 && Math.max(red, green, blue) > 20;
    case 'shadow':
      // Black, as dark as the shadow is set to be; what is left of the light around is not its affair.
      return Math.max(red, green, blue) === 0 && alpha > SHADOW_STRENGTH * 255 * 0.8;
    case 'lit floor':
    case 'hidden':
    case 'room':
      return alpha <= 2;
  }
}

/** Eyes as WebXR tells them to the page, asked of the running session by the test. */
export async function eyesOf(xr: XrPage): Promise<Eye[]> {
  const eyes = await xr.page.evaluate(async () => {
    const session = (scrimEmulator?.current?.device as unknown as { activeSession?: XRSession })?.activeSession;
    if (!session) throw new Error('There is no session.');
    const space = await session.requestReferenceSpace('local-floor');
    const told = new Promise<{ pose: number[]; projection: number[] }[]>((resolve) => {
      session.requestAnimationFrame((_time, frame) => {
        const views = frame.getViewerPose(space)?.views ?? [];
        resolve(views.map(({ transform, projectionMatrix }) => ({ pose: [...transform.matrix], projection: [...projectionMatrix] })));
      });
    });
    await scrimEmulator?.current?.stepFrame();
    return told;
  });
  const width = WIDTH / eyes.length;
  return eyes.map(({ pose, projection }, i) => ({
    origin: [pose[12] ?? 0, pose[13] ?? 0, pose[14] ?? 0],
    worldFromView: pose,
    clipFromView: projection,
    left: i * width,
    width,
  }));
}

/** Whether the box or its floor lies on the ray, which alone makes the room of interest: casting at scans takes milliseconds. */
function meets(place: Place, origin: Vector, ray: Vector): boolean {
  if (Number.isFinite(boxAlong(place, origin, ray, MARGIN_M))) return true;
  const floor = -origin[1] / ray[1];
  const within = FLOOR_HALF_M + MARGIN_M;
  return floor > 0 && Math.abs(origin[0] + ray[0] * floor) < within && Math.abs(origin[2] + ray[2] * floor) < within;
}

/** Distances to the room in the rays' own lengths, of those that `matters` picks. */
async function castAll(xr: XrPage, origin: Vector, rays: readonly Vector[], matters: (ray: Vector) => boolean): Promise<number[]> {
  const asked = rays.filter(matters);
  const distances = await xr.page.evaluate(([from, all]) => all.map((ray) => scrimEmulator?.current?.measure(from, ray) ?? null), [
    origin,
    asked,
  ] as const);
  const along = new Map(asked.map((ray, i) => [ray, (distances[i] ?? Number.POSITIVE_INFINITY) / Math.hypot(...ray)]));
  return rays.map((ray) => along.get(ray) ?? Number.POSITIVE_INFINITY);
}

export interface Tally {
  readonly counts: Readonly<Record<Exclude<Expected, null>, number>>;
  readonly wrong: readonly string[];
}

/** `marginPx`: how far around a pixel all has to be alike for it to count. `leaveOut`: kinds that do not count. */
export async function tally(
  xr: XrPage,
  place: Place,
  eye: Eye,
  layer: RgbaImage,
  { marginPx = MARGIN_PX, leaveOut = [] }: { readonly marginPx?: number; readonly leaveOut?: readonly Expected[] } = {},
): Promise<Tally> {
  const counts = { box: 0, shadow: 0, 'lit floor': 0, hidden: 0, room: 0 };
  const wrong: string[] = [];
  const corners = [
    [-marginPx, -marginPx],
    [marginPx, marginPx],
    [marginPx, -marginPx],
  ] as const;
  const pixels: (readonly [number, number])[] = [];
  for (let y = STEP_PX; y < HEIGHT - STEP_PX; y += STEP_PX) {
    for (let x = eye.left + STEP_PX; x < eye.left + eye.width - STEP_PX; x += STEP_PX) pixels.push([x, y]);
  }
  const rays = pixels.flatMap(([x, y]) => corners.map(([dx, dy]) => rayOf(eye, x + dx, y + dy)));
  const room = await castAll(xr, eye.origin, rays, (ray) => meets(place, eye.origin, ray));
  pixels.forEach(([x, y], i) => {
    // The same at three corners around it, else an outline runs through.
    const around = corners.map((_, c) => expectedAt(place, eye, rays[i * 3 + c] ?? [0, 0, -1], room[i * 3 + c] ?? 0));
    const [expected] = around;
    if (!expected || leaveOut.includes(expected) || around.some((other) => other !== expected)) return;
    counts[expected]++;
    const pixel = pixelAt(layer, x, y);
    if (!isAsExpected(expected, pixel))
      wrong.push(`(${x}, ${y}) has to show ${expected}, the room being at ${room[i * 3]?.toFixed(2)}, and is ${pixel}`);
  });
  return { counts, wrong };
}

/** Where eyes may stand around the box, and how high. */
const HEIGHTS_M = [1.5, 0.75];
const WAYS = 6;
/** From walls behind the eye. */
const CLEAR_M = 0.5;

/** `yaw` is where the eye stands, about the vertical. */
function poseAt([px, pz]: Place, yaw: number, distanceM: number, heightM: number): { readonly matrix: number[]; readonly eye: Vector } {
  const away = [Math.sin(yaw) * distanceM, Math.cos(yaw) * distanceM] as const;
  const eye: Vector = [px + away[0], heightM, pz + away[1]];
  // Between the box and its shadow.
  const back = unit([away[0] + 0.2, heightM - 0.1, away[1] + 0.3]);
  const right = unit([back[2], 0, -back[0]]);
  const up: Vector = [
    back[1] * right[2] - back[2] * right[1],
    back[2] * right[0] - back[0] * right[2],
    back[0] * right[1] - back[1] * right[0],
  ];
  return { matrix: [...right, 0, ...up, 0, ...back, 0, ...eye, 1], eye };
}

function unit([x, y, z]: Vector): Vector {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}

/** Of all places around the box that from which most of the shadow is seen, and that from which most is hidden, judged by a few rays. */
export async function findPoses(xr: XrPage, place: Place): Promise<number[][]> {
  const found: { matrix: number[]; shadow: number; hidden: number }[] = [];
  for (const heightM of HEIGHTS_M) {
    for (let way = 0; way < WAYS; way++) {
      const yaw = (way / WAYS) * 2 * Math.PI;
      const [free = 0] = await castAll(xr, [place[0], heightM, place[1]], [[Math.sin(yaw), 0, Math.cos(yaw)]], () => true);
      // What is nearer than the near plane is not drawn, by cameras of depth neither.
      if (free < 2 * CLEAR_M) continue;
      const { matrix, eye } = poseAt(place, yaw, Math.min(2, free - CLEAR_M), heightM);
      const look: Eye = { origin: eye, worldFromView: matrix, clipFromView: [1.2, 0, 0, 0, 0, 1.6], left: 0, width: WIDTH };
      const rays = Array.from({ length: 180 }, (_, i) =>
        rayOf(look, ((i % 15) + 0.5) * (WIDTH / 15), (Math.floor(i / 15) + 0.5) * (HEIGHT / 12)),
      );
      const room = await castAll(xr, eye, rays, (ray) => meets(place, eye, ray));
      const kinds = rays.map((ray, i) => expectedAt(place, look, ray, room[i] ?? 0));
      const count = (kind: Expected) => Math.min(20, kinds.filter((other) => other === kind).length);
      found.push({
        matrix,
        shadow: 4 * count('shadow') + 2 * Math.min(4, count('lit floor')) + count('box'),
        hidden: 4 * count('hidden') + count('box'),
      });
    }
  }
  const best = (of: 'shadow' | 'hidden') => [...found].sort((one, other) => other[of] - one[of])[0]?.matrix ?? [];
  return [best('shadow'), best('hidden')];
}
