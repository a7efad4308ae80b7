import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { DirectionalLightItem, ProbeLightItem } from '../../kit/scene-lists.ts';
import type { LightEstimate } from '../../kit/session.ts';
import { createSunShadow } from '../../kit/sun-shadow.ts';
import type { definition } from './definition.ts';
import { createRoomLight, DEFAULT_MEAN, guessLight, type RoomLight } from './guess-light.ts';

/**
 * How long an old estimate is used, seconds. Devices skip frames and lose tracking for a moment; the old estimate is better than a
 * guess from the camera image.
 */
const HOLD_S = 2;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { intensity, smoothingS } = ctx.params;
  const primary: DirectionalLightItem = {
    key: 'primary',
    kind: 'directional',
    radiance: new Float32Array(3),
    towardsLightWorld: new Float32Array(3),
    shadow: null,
  };
  const around: ProbeLightItem = {
    key: 'around',
    kind: 'probe',
    sphericalHarmonics: new Float32Array(27),
    reflection: null,
    intensity: 1,
  };
  ctx.outputs.lights.items.push(primary, around);
  ctx.outputs.lights.version++;
  const shadow = createSunShadow(ctx);
  const target = createRoomLight();
  const now = createRoomLight();
  /** The time of the last estimate; null if there was none. */
  let estimatedS: number | null = null;
  /** Whether the next light applies without smoothing, as the first one does. */
  let fresh = true;
  /** Whether the last guess was made from a camera image. */
  let measured = false;

  function findTarget(light: LightEstimate | null): void {
    const { timeS } = ctx.clock;
    if (light) {
      // The first estimate applies without smoothing too.
      if (estimatedS === null) fresh = true;
      estimatedS = timeS;
      takeOver(target, light);
      around.reflection = light.reflection ?? null;
    } else if (estimatedS === null || timeS - estimatedS > HOLD_S) {
      // Without smoothing: a fade from a guess without a camera image would be visible.
      const mean = ctx.session.cameraMean;
      if (mean && estimatedS === null && !measured) fresh = true;
      measured = mean !== null;
      around.reflection = null;
      guessLight(target, mean ?? DEFAULT_MEAN);
    }
  }

  function reset(): void {
    estimatedS = null;
    fresh = true;
    measured = false;
  }

  return {
    update: () => {
      findTarget(ctx.session.light);
      // The fraction of the difference in this frame, independent of the frame rate.
      approach(now, target, fresh || smoothingS.value <= 0 ? 1 : 1 - Math.exp(-ctx.clock.deltaS / smoothingS.value));
      fresh = false;
      around.sphericalHarmonics.set(now.sphericalHarmonics);
      around.intensity = intensity.value;
      primary.towardsLightWorld.set(now.directionWorld);
      for (let c = 0; c < 3; c++) primary.radiance[c] = (now.irradiance[c] ?? 0) * intensity.value;
      shadow.update(primary);
    },
    reset,
    dispose: () => {},
  };
}

function takeOver(into: RoomLight, light: LightEstimate): void {
  into.sphericalHarmonics.set(light.sphericalHarmonics);
  into.irradiance.set(light.primaryIntensity);
  const [x = 0, y = 0, z = 0] = light.primaryDirectionWorld;
  const length = Math.hypot(x, y, z);
  // Without a directional light, keep the last direction.
  if (length < 1e-6) return;
  into.directionWorld[0] = x / length;
  into.directionWorld[1] = y / length;
  into.directionWorld[2] = z / length;
}

/** Moves a light by a part towards a target: interpolates colors linearly, and normalizes the direction. */
function approach(light: RoomLight, target: RoomLight, part: number): void {
  mix(light.sphericalHarmonics, target.sphericalHarmonics, part);
  mix(light.irradiance, target.irradiance, part);
  mix(light.directionWorld, target.directionWorld, part);
  const [x = 0, y = 0, z = 0] = light.directionWorld;
  const length = Math.hypot(x, y, z);
  // Halfway between opposite directions the sum is 0: keep the old direction.
  if (length < 1e-3) light.directionWorld.set(target.directionWorld);
  else for (let i = 0; i < 3; i++) light.directionWorld[i] = (light.directionWorld[i] ?? 0) / length;
}

function mix(from: Float32Array, to: Float32Array, part: number): void {
  for (let i = 0; i < from.length; i++) from[i] = (from[i] ?? 0) + ((to[i] ?? 0) - (from[i] ?? 0)) * part;
}
