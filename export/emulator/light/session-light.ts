import { createRandom } from '../../runtime/random.ts';
import type { RoomLight } from './room-light.ts';

/** Behavior of light estimation on this device. */
export interface LightOptions {
  /** Delay of the estimate, in frames. */
  readonly lagFrames?: number;
  /** Standard deviation of intensities and coefficients, relative to their value; it differs in each frame. The direction has no noise. */
  readonly flicker?: number;
  readonly seed?: number;
}

export const LIGHT_DEFAULTS: Required<LightOptions> = { lagFrames: 0, flicker: 0, seed: 0 };

/**
 * What light estimation returns. `room`: the light of the room. `stopped`: no estimate. `frozen`: the last estimate in every frame. An
 * object overrides parts of the room's light.
 */
export type LightState = 'room' | 'stopped' | 'frozen' | LightChanges;

/** Parts of the light estimate that differ from the room's light. Missing values are those of the room. */
export interface LightChanges {
  /** 27 numbers, linear-sRGB radiance, world space. */
  readonly sphericalHarmonics?: readonly number[];
  /** Null if the device estimates no direction or no intensity. */
  readonly directionWorld?: readonly [number, number, number] | null;
  readonly intensity?: readonly [number, number, number] | null;
  /** One color per face of the cube map: +x, −x, +y, −y, +z, −z; linear radiance. Null if there is no cube map. */
  readonly reflection?: readonly (readonly [number, number, number])[] | null;
}

/** The estimate of one frame. */
export interface EstimatedLight {
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
  /**
   * Advances by one frame; called before the page's callbacks. `roomMoves` counts changes of the room's light. Returns whether the cube map
   * changed.
   */
  follow(state: LightState, roomMoves?: number): boolean;
  /** The estimate of this frame, or null. */
  estimate(): EstimatedLight | null;
  reflection(): ReflectionFaces | null;
}

export function createSessionLight(measured: () => RoomLight | null, options: Required<LightOptions>): SessionLight {
  /** Newest last. The first is the one reported, `lagFrames` frames old. */
  const states: LightState[] = [];
  let state: LightState = 'room';
  /** The state reported before it froze. */
  let kept: LightState = 'room';
  let frames = 0;
  /** The state and the value of `roomMoves` that the current cube map shows. */
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
      const estimated = intensity === undefined ? room.intensity : intensity;
      return {
        sphericalHarmonics: Float32Array.from(sphericalHarmonics, (value) => value * brightness),
        directionWorld: directionWorld === undefined ? room.directionWorld : directionWorld,
        intensity: estimated && [estimated[0] * brightness, estimated[1] * brightness, estimated[2] * brightness],
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

/** Identity of the cube map's content: equal values mean equal cube maps. */
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
