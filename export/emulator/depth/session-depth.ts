import type { Eye } from '../display/eye.ts';
import type { RoomView } from '../display/room-view.ts';
import type { DepthConfiguration } from '../features.ts';
import type { DepthOptions } from '../options.ts';
import { createDepthCamera } from './depth-camera.ts';
import { addDepthNoise } from './depth-noise.ts';
import { aimSensor, type DepthCameraPose } from './depth-sensor.ts';
import { affineToMatrix, depthUvFromViewUv } from './depth-transform.ts';

/** What depth sensing returns. `stopped`: no depth. `frozen`: every frame has the last depth. */
export type DepthState = 'working' | 'stopped' | 'frozen';

/** One depth image and the pose it was taken from. */
export interface DepthShot extends DepthCameraPose {
  /** Meters, row-major from the top; 0 where unknown. */
  readonly meters: Float32Array;
}

/** The depth sensing granted to one session. */
export interface SessionDepth extends DepthConfiguration {
  readonly widthPx: number;
  readonly heightPx: number;
  /** Column-major 4×4. */
  readonly bufferFromView: Float32Array;
  readonly gpuValues: 'meters' | 'window';
  /** Whether depth sensing is active; the page can pause it (WebXR Depth Sensing §2.3). */
  active: boolean;
  /** Records the eyes of this frame; called once per frame, before the page's callbacks. */
  follow(eyes: readonly Eye[], nearM: number, farM: number, state: DepthState): void;
  /** Depth of the view with this index, constant during a frame; null if there is none. */
  shot(index: number): DepthShot | null;
  dispose(): void;
}

/** Depth poses of one frame, and the frame's number. */
interface Stand {
  readonly frame: number;
  readonly poses: readonly DepthCameraPose[];
}

export function createSessionDepth(view: RoomView, granted: DepthConfiguration, options: Required<DepthOptions>): SessionDepth {
  const [widthPx, heightPx] = options.sizePx;
  const { lagFrames, noise, maxM } = options;
  const map = depthUvFromViewUv(options.transform);
  const camera = createDepthCamera(view, widthPx, heightPx, map);
  const sensor = granted.matchView ? null : options.sensor;
  const turned = (options.transform.turnDeg ?? 0) % 180 !== 0;
  const aspect = turned ? heightPx / widthPx : widthPx / heightPx;
  /** Newest last. The first is the one that the sensor reports, `lagFrames` frames old. */
  const stands: Stand[] = [];
  const shots = new Map<number, DepthShot>();
  /** Arrays of former shots. Pages get encoded copies. */
  const spare: Float32Array[] = [];
  let frames = 0;
  let stopped = false;

  const measure = (stand: Stand, index: number): DepthShot | null => {
    const pose = stand.poses[index];
    if (!pose) return null;
    const measured = camera.measure(pose);
    const meters = spare.pop() ?? new Float32Array(measured.length);
    meters.set(measured);
    if (maxM !== null) for (let i = 0; i < meters.length; i++) if ((meters[i] ?? 0) > maxM) meters[i] = 0;
    if (noise) addDepthNoise(meters, noise, `${stand.frame}/${index}`);
    return { ...pose, meters };
  };
  const depth: SessionDepth = {
    ...granted,
    widthPx,
    heightPx,
    bufferFromView: affineToMatrix(map),
    gpuValues: options.gpuValues,
    active: true,
    follow: (eyes, nearM, farM, state) => {
      stopped = state === 'stopped';
      const frame = frames++;
      if (state === 'frozen' && stands.length > 0) return;
      stands.push({ frame, poses: eyes.map((eye) => aimSensor(sensor, eye, aspect, nearM, farM)) });
      if (stands.length > lagFrames + 1) stands.shift();
      for (const { meters } of shots.values()) spare.push(meters);
      shots.clear();
    },
    shot: (index) => {
      const [stand] = stands;
      if (stopped || !depth.active || !stand) return null;
      const known = shots.get(index) ?? measure(stand, index);
      if (known) shots.set(index, known);
      return known;
    },
    dispose: camera.dispose,
  };
  return depth;
}
