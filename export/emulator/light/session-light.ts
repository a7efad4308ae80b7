import { createRandom } from '../../runtime/random.ts';
import type { RoomLight } from './room-light.ts';

/** How light estimation behaves on this device. */
export interface LightOptions {
  /** Frames by which estimates come late. */
  readonly lagFrames?: number;
  /** Standard deviation of all that is estimated but the direction, as a share of it: each frame has its own. */
  readonly flicker?: number;
  readonly seed?: number;
}

export const LIGHT_DEFAULTS: Required<LightOptions> = { lagFrames: 0, flicker: 0, seed: 0 };

/** `room`: the room's light. `stopped`: no estimate any more. `frozen`: every frame has the last estimate. Else the room's light, changed. */
export type LightState = 'room' | 'stopped' | 'frozen' | LightChanges;

/** What is left out is as in the room. */
export interface LightChanges {
  /** 27 numbers, linear-sRGB radiance, world space. */
  readonly sphericalHarmonics?: readonly number[];
  /** Null: the device finds no direction, or no intensity. */
  readonly directionWorld?: readonly [number, number, number] | null;
  readonly intensity?: readonly [number, number, number] | null;
  /** A color for each face of the cube map: +x, −x, +y, −y, +z, −z; linear radiance. Null: there is no cube map. */
  readonly reflection?: readonly (readonly [number, number, number])[] | null;
}

/** What one frame's estimate says. */
export interface SaidLight {
  readonly sphericalHarmonics: Float32Array;
  readonly directionWorld: readonly [number, number, number] | null;
  readonly intensity: readonly [number, number, number] | null;
}

export interface ReflectionFaces {
  readonly cubeFaces: readonly Float32Array[];
  readonly cubeSizePx: number;
}

/** Light estimation in one session. */
export interface SessionLight {
  /** Once a frame, before the page is asked. `roomMoves`: how often the room's light was moved. True when the cube map is another one now. */
  follow(state: LightState, roomMoves?: number): boolean;
  /** Of this frame; null where the device has none. */
  estimate(): SaidLight | null;
  reflection(): ReflectionFaces | null;
}

export function createSessionLight(measured: () => RoomLight | null, options: Required<LightOptions>): SessionLight {
  /** The newest last; the first is what is told by now. */
  const states: LightState[] = [];
  let state: LightState = 'room';
  /** What was told before it froze. */
  let kept: LightState = 'room';
  let frames = 0;
  /** The state that the cube map is of, and how often the room's light had been moved by then. */
  let shown: LightState | null = null;
  let shownMoves = 0;

  const changes = (): LightChanges => {
    const of = state === 'frozen' ? kept : state;
    return typeof of === 'object' ? of : {};
  };
  return {
    follow: (next, roomMoves = 0) => {
      states.push(next);
      if (states.length > options.lagFrames + 1) states.shift();
      state = states[0] ?? next;
      if (state !== 'frozen') {
        kept = state;
        frames++;
      }
      const moved = roomMoves !== shownMoves && sourceOf(kept) === 'room';
      const changed = shown !== null && (moved || sourceOf(shown) !== sourceOf(kept));
      shown = kept;
      shownMoves = roomMoves;
      return changed;
    },
    estimate: () => {
      const room = measured();
      if (!room || state === 'stopped') return null;
      const { sphericalHarmonics = room.sphericalHarmonics, directionWorld, intensity } = changes();
      const brightness = flicker(options, frames);
      const told = intensity === undefined ? room.intensity : intensity;
      return {
        sphericalHarmonics: Float32Array.from(sphericalHarmonics, (value) => value * brightness),
        directionWorld: directionWorld === undefined ? room.directionWorld : directionWorld,
        intensity: told && [told[0] * brightness, told[1] * brightness, told[2] * brightness],
      };
    },
    reflection: () => {
      const room = measured();
      const { reflection } = changes();
      if (!room || reflection === null) return null;
      return reflection ? flatFaces(reflection) : room;
    },
  };
}

/** What decides the cube map: the same value for the same one. */
function sourceOf(state: LightState): unknown {
  return typeof state === 'object' ? (state.reflection ?? (state.reflection === null ? null : 'room')) : 'room';
}

function flicker({ flicker: sigma, seed }: Required<LightOptions>, frame: number): number {
  if (sigma === 0) return 1;
  const { next } = createRandom(seed, `light/${frame}`);
  const normal = Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());
  return Math.max(0, 1 + sigma * normal);
}

const FLAT_SIZE_PX = 4;

function flatFaces(colors: readonly (readonly [number, number, number])[]): ReflectionFaces {
  const cubeFaces = colors.map(([r, g, b]) => {
    const face = new Float32Array(FLAT_SIZE_PX * FLAT_SIZE_PX * 4);
    for (let i = 0; i < face.length; i += 4) face.set([r, g, b, 1], i);
    return face;
  });
  return { cubeFaces, cubeSizePx: FLAT_SIZE_PX };
}
