import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { DirectionalLightItem, ProbeLightItem } from '../../kit/scene-lists.ts';
import type { LightEstimate } from '../../kit/session.ts';
import { createSunShadow } from '../../kit/sun-shadow.ts';
import type { definition } from './definition.ts';
import { createRoomLight, DEFAULT_MEAN, guessLight, type RoomLight } from './guess-light.ts';

/**
 * How long an estimate counts that is not renewed, seconds: devices leave out frames and lose their place for a moment, and what
 * the room was like then is better than a guess.
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
  /** Since when there has been no estimate; null where there never was one. */
  let estimatedS: number | null = null;
  /** The first light of all is there at once. */
  let fresh = true;
  /** Whether the last guess was made from a picture. */
  let measured = false;

  function findTarget(light: LightEstimate | null): void {
    const { timeS } = ctx.clock;
    if (light) {
      // Nor is the first estimate one that the light has to come near to.
      if (estimatedS === null) fresh = true;
      estimatedS = timeS;
      takeOver(target, light);
      around.reflection = light.reflection ?? null;
    } else if (estimatedS === null || timeS - estimatedS > HOLD_S) {
      // A first guess made before the camera's picture is measured would be seen to fade away.
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
      // The part of the way to go in this frame, whatever the frame rate.
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
  // Without a strongest light there is no direction: the last one will do.
  if (length < 1e-6) return;
  into.directionWorld[0] = x / length;
  into.directionWorld[1] = y / length;
  into.directionWorld[2] = z / length;
}

/** Linear in the coefficients, so that sums of lights stay such; the direction is brought back to length 1. */
function approach(light: RoomLight, target: RoomLight, part: number): void {
  mix(light.sphericalHarmonics, target.sphericalHarmonics, part);
  mix(light.irradiance, target.irradiance, part);
  mix(light.directionWorld, target.directionWorld, part);
  const [x = 0, y = 0, z = 0] = light.directionWorld;
  const length = Math.hypot(x, y, z);
  // Halfway between opposite directions there is none.
  if (length < 1e-3) light.directionWorld.set(target.directionWorld);
  else for (let i = 0; i < 3; i++) light.directionWorld[i] = (light.directionWorld[i] ?? 0) / length;
}

function mix(from: Float32Array, to: Float32Array, part: number): void {
  for (let i = 0; i < from.length; i++) from[i] = (from[i] ?? 0) + ((to[i] ?? 0) - (from[i] ?? 0)) * part;
}
