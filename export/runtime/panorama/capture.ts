import { AIM_RAD, captureTargets, type Direction, MOST_TARGETS, targetsForHoles } from '../../../nodes/kit/panorama/capture-targets.ts';
import type { PanoramaShot } from '../../../nodes/kit/panorama/shot.ts';
import type { SessionFrame, ViewFrame } from '../../../nodes/kit/session.ts';
import type { Writable } from '../../../nodes/kit/value-views.ts';

/** A direction to photograph, and whether its photo is taken. */
export interface CaptureTarget {
  readonly direction: Direction;
  taken: boolean;
}

/**
 * Takes the photos of a panorama, each automatically when the camera points at a target and is held still.
 *
 * `waiting`: there was no camera image yet. `blind`: the session gives no camera image. `taking`: targets are left. `complete`: all targets
 * are taken, and no more are added for holes.
 */
export interface PanoramaCapture {
  readonly state: 'waiting' | 'blind' | 'taking' | 'complete';
  /** All targets, taken or not, in the order in which they appeared. */
  readonly targets: readonly CaptureTarget[];
  readonly shots: readonly PanoramaShot[];
  /** The target that is nearest to the direction of the camera among those not taken; null if all are. */
  readonly next: CaptureTarget | null;
  /** How long the camera has been held still on the target, as a fraction in [0, 1] of the time that a photo needs. */
  readonly held: number;
  /** Whether the camera is too far from the place of the first photo. No photo is taken there, because near things would look shifted. */
  readonly isAway: boolean;
  /** Called once per frame: updates the targets and takes a photo if one is due. */
  update(frame: SessionFrame): void;
  /** The photos for stitching, with the newest lens, and the position of the camera at the first photo. */
  result(): { readonly shots: readonly PanoramaShot[]; readonly at: readonly [number, number, number] };
  /**
   * Starts again with photos of an earlier session.
   *
   * @param shots In the world space of this session.
   * @param headingRad The angle by which the photos were turned into this world space, counterclockwise seen from above. The targets are
   * turned by the same angle.
   */
  adopt(shots: readonly PanoramaShot[], headingRad: number): void;
  /** Drops all photos and targets. */
  restart(): void;
}

export interface CaptureOptions {
  /** Reads the camera image of the view, in the given size or a smaller one. */
  readonly read: (view: ViewFrame, widthPx: number, heightPx: number) => PanoramaShot;
  /** Width of the panorama, which determines the size of the photos. */
  readonly widthPx: number;
  /** How long the camera has to hold still, seconds. */
  readonly holdS: number;
}

/** Maximum speeds at which the camera counts as still: an exposure of 1/30 s is then blurred by less than a pixel of the panorama. */
const STILL_RAD_PER_S = 0.12;
const STILL_M_PER_S = 0.25;
/** Time without a camera image after which the session is taken to give none. */
const BLIND_S = 2.5;
/** Maximum distance from the first photo, meters. Farther away, things at 2 m look shifted by more than 10°. */
const AWAY_M = 0.4;
/** Pixels of a photo per pixel of the panorama, along each axis. Stitching averages them. */
const PIXELS_PER_PIXEL = 1.5;
const MOST_SIDE_PX = 1024;
/** How many times targets are added for holes that the photos leave. Stitching fills what is still left then. */
const EXTRA_TURNS = 2;

/** Its lists are replaced, not changed. */
const BEGINNING = {
  state: 'waiting',
  targets: [],
  shots: [],
  next: null,
  held: 0,
  isAway: false,
} as const satisfies Partial<PanoramaCapture>;

export function createPanoramaCapture({ read, widthPx, holdS }: CaptureOptions): PanoramaCapture {
  let stillSinceS = 0;
  let blindSinceS = -1;
  let extraTurns = 0;
  /** The angle by which the targets are turned, counterclockwise seen from above. */
  let headingRad = 0;
  const last = { timeS: -1, worldFromView: new Float32Array(16) };
  const first = new Float32Array(3);
  /** Projection matrix of the newest frame (`clipFromView`). */
  const lens = new Float32Array(16);

  const capture: Writable<PanoramaCapture> = {
    ...BEGINNING,
    update,
    result: () => ({ shots: sharedLens(), at: [first[0] ?? 0, first[1] ?? 0, first[2] ?? 0] }),
    adopt: (others, turnedRad) => {
      restart();
      capture.shots = [...others];
      headingRad = turnedRad;
      const [newest] = others;
      for (let i = 0; newest && i < 3; i++) first[i] = newest.worldFromView[12 + i] ?? 0;
    },
    restart,
  };

  function restart(): void {
    Object.assign(capture, BEGINNING);
    blindSinceS = -1;
    extraTurns = 0;
    headingRad = 0;
    last.timeS = -1;
  }

  function begin(view: ViewFrame): void {
    const [cos, sin] = [Math.cos(headingRad), Math.sin(headingRad)];
    capture.targets = captureTargets(view.clipFromView).map(([x, y, z]) => ({
      direction: [x * cos + z * sin, y, z * cos - x * sin],
      taken: false,
    }));
    capture.state = 'taking';
    for (const shot of capture.shots) mark(shot.worldFromView);
  }

  /** Marks the targets near the center of a photo as taken. */
  function mark(worldFromView: Float32Array): void {
    for (const target of capture.targets) if (angleTo(worldFromView, target.direction) <= AIM_RAD * 1.5) target.taken = true;
  }

  function watchStillness({ worldFromView }: ViewFrame, timeS: number): void {
    const deltaS = timeS - last.timeS;
    const moves =
      last.timeS < 0 ||
      turnBetween(last.worldFromView, worldFromView) > STILL_RAD_PER_S * deltaS ||
      distanceBetween(last.worldFromView, worldFromView) > STILL_M_PER_S * deltaS;
    if (moves) stillSinceS = timeS;
    last.timeS = timeS;
    last.worldFromView.set(worldFromView);
  }

  function nearest(worldFromView: Float32Array): CaptureTarget | null {
    let best: CaptureTarget | null = null;
    let least = Number.POSITIVE_INFINITY;
    for (const target of capture.targets) {
      const angle = target.taken ? Number.POSITIVE_INFINITY : angleTo(worldFromView, target.direction);
      if (angle >= least) continue;
      least = angle;
      best = target;
    }
    return best;
  }

  function takePhoto(view: ViewFrame, target: CaptureTarget): void {
    const { worldFromView } = view;
    if (capture.shots.length === 0) for (let i = 0; i < 3; i++) first[i] = worldFromView[12 + i] ?? 0;
    const perRad = (widthPx / (2 * Math.PI)) * PIXELS_PER_PIXEL;
    const side = (i: number): number =>
      Math.max(16, Math.min(MOST_SIDE_PX, Math.round(2 * Math.atan(1 / (view.clipFromView[i] ?? 1)) * perRad)));
    capture.shots = [...capture.shots, read(view, side(0), side(5))];
    target.taken = true;
    if (nearest(worldFromView) === null) finishRound(view);
  }

  /** Adds targets for what the photos do not show; if there are none, the capture is complete. */
  function finishRound({ clipFromView }: ViewFrame): void {
    const extra = extraTurns < EXTRA_TURNS ? targetsForHoles(sharedLens(), clipFromView, MOST_TARGETS - capture.targets.length) : [];
    extraTurns++;
    capture.targets = [...capture.targets, ...extra.map((direction) => ({ direction, taken: false }))];
    if (extra.length === 0) capture.state = 'complete';
  }

  /**
   * The photos with the newest lens in place of their own, where the aspect ratios agree: a session that estimates the lens improves its
   * estimate with time.
   */
  function sharedLens(): PanoramaShot[] {
    const shape = (lens[0] ?? 1) / (lens[5] ?? 1);
    return capture.shots.map((shot) => {
      const own = (shot.clipFromView[0] ?? 1) / (shot.clipFromView[5] ?? 1);
      return Math.abs(own / shape - 1) < 0.01 ? { ...shot, clipFromView: lens.slice() } : shot;
    });
  }

  function update(frame: SessionFrame): void {
    const view = frame.views[0];
    if (!view || frame.viewCount === 0 || capture.state === 'complete') return;
    if (!view.cameraImage) {
      if (blindSinceS < 0) blindSinceS = frame.timeS;
      if (capture.state !== 'taking' && frame.timeS - blindSinceS >= BLIND_S) capture.state = 'blind';
      return;
    }
    if (capture.state !== 'taking') begin(view);
    lens.set(view.clipFromView);
    watchStillness(view, frame.timeS);
    capture.next = nearest(view.worldFromView);
    capture.isAway =
      capture.shots.length > 0 && Math.hypot(...[0, 1, 2].map((i) => (view.worldFromView[12 + i] ?? 0) - (first[i] ?? 0))) > AWAY_M;
    const aims = capture.next !== null && angleTo(view.worldFromView, capture.next.direction) <= AIM_RAD;
    if (!aims) stillSinceS = frame.timeS;
    capture.held = aims ? Math.min(1, holdS === 0 ? 1 : (frame.timeS - stillSinceS) / holdS) : 0;
    if (capture.next !== null && capture.held >= 1 && !capture.isAway) {
      takePhoto(view, capture.next);
      stillSinceS = frame.timeS;
      capture.next = nearest(view.worldFromView);
    }
  }

  return capture;
}

/** Angle between the axis of a camera and a direction. */
function angleTo(m: Float32Array, [x, y, z]: Direction): number {
  return Math.acos(Math.min(1, Math.max(-1, -((m[8] ?? 0) * x + (m[9] ?? 0) * y + (m[10] ?? 0) * z))));
}

function turnBetween(a: Float32Array, b: Float32Array): number {
  let trace = 0;
  for (let column = 0; column < 3; column++) {
    for (let row = 0; row < 3; row++) trace += (a[4 * column + row] ?? 0) * (b[4 * column + row] ?? 0);
  }
  return Math.acos(Math.min(1, Math.max(-1, (trace - 1) / 2)));
}

function distanceBetween(a: Float32Array, b: Float32Array): number {
  return Math.hypot((a[12] ?? 0) - (b[12] ?? 0), (a[13] ?? 0) - (b[13] ?? 0), (a[14] ?? 0) - (b[14] ?? 0));
}
