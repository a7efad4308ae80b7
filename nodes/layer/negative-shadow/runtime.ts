import { linearFromSrgb, srgbFromLinear } from '../../kit/color-math.ts';
import { NOTHING_TO_FALL_ON } from '../../kit/light-shadow.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { MAX_GLOW_SPOTS, type ShadowGlow } from '../../kit/scene-look.ts';
import { createBoundingCylinders } from '../../kit/three/bounding-cylinders.ts';
import type { definition } from './definition.ts';
import { addSpot, isShadowLight } from './glow-spots.ts';

const TOO_FAINT = {
  code: 'SCR049',
  severity: 'warning',
  port: 'base',
  message: 'On this display, shadows are less than 2 of 256 levels darker than the light around them.',
  fix: 'Choose a brighter “Base” or a greater “Depth of shadow”.',
} as const;

/** A shadow that is fewer levels (of 256) darker than the light around it is invisible. */
const MIN_LEVELS = 2;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { base, depthOfShadow, margin, border, maxStretchM, color, toleranceM } = ctx.params;
  const { casters, depth, receivers, lights } = ctx.inputs;
  const cylinders = createBoundingCylinders();
  const strength = { value: 0 };
  const shape = { margin: 0, maxStretchM: 0 };
  const glow: ShadowGlow = {
    on: false,
    color: base,
    border,
    count: 0,
    places: new Float32Array(MAX_GLOW_SPOTS * 4),
    sizes: new Float32Array(MAX_GLOW_SPOTS * 4),
  };
  const scene = ctx.scenes.createScene({
    kind: 'shadow-catcher',
    strength,
    color,
    glow,
    ...(depth ? { room: { depth, toleranceM } } : {}),
  });

  function addSpots(): void {
    glow.count = 0;
    shape.margin = margin.value;
    shape.maxStretchM = maxStretchM.value;
    const objects = cylinders.update(casters);
    for (const { items } of lights) {
      for (const light of items) {
        if (!isShadowLight(light)) continue;
        for (let i = 0; i < objects.length; i++) {
          const cylinder = objects[i];
          if (cylinder) addSpot(glow, cylinder, light, shape);
        }
      }
    }
  }

  return {
    update: () => {
      if (receivers.length === 0 && !depth) ctx.report(NOTHING_TO_FALL_ON);
      glow.on = ctx.session.blend === 'additive';
      strength.value = glow.on ? depthOfShadow.value : ctx.params.strength.value;
      if (glow.on) {
        addSpots();
        if (shadowLevels(base.value, depthOfShadow.value, ctx.session.cameraMean) < MIN_LEVELS) ctx.report(TOO_FAINT);
      }
      scene.update(receivers, lights);
    },
    draw: scene.draw,
    dispose: scene.dispose,
  };
}

/** Brightness of white on the display relative to white in the room, typical of additive displays in rooms. */
const DISPLAY_GAIN = 2;

/**
 * By how many of 256 levels a shadow looks darker than the light around it on an additive display, which the eye sees as room + gain ×
 * display.
 *
 * @param base Display-referred sRGB.
 * @param roomLinear Mean linear color of the room; null if no camera sees it, which counts as dark.
 */
function shadowLevels(base: ArrayLike<number>, depthOfShadow: number, roomLinear: ArrayLike<number> | null): number {
  let most = 0;
  for (let c = 0; c < 3; c++) {
    const room = roomLinear?.[c] ?? 0;
    const lit = DISPLAY_GAIN * linearFromSrgb(base[c] ?? 0);
    most = Math.max(most, srgbFromLinear(Math.min(1, room + lit)) - srgbFromLinear(Math.min(1, room + lit * (1 - depthOfShadow))));
  }
  return most * 255;
}
