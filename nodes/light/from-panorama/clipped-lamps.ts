import { gainOfContrast, primaryContrast } from '../../kit/panorama/clipped-light.ts';
import type { FoundLamp, FoundLamps } from '../../kit/panorama/found-lamps.ts';
import { luminanceOf } from '../../kit/panorama/sphere-grid.ts';
import type { SessionService } from '../../kit/runtime.ts';

/** Brightens lamps that are clipped to white in the panorama as far as the light estimation of the device says. */
export interface ClippedLamps {
  /** Reads the estimate of this frame. Call it once per frame; `found` is null while there are no lamps. */
  update(found: FoundLamps | null): void;
  /** Writes the irradiance of a lamp of `found`. */
  write(into: number[], lamp: FoundLamp): void;
}

export function createClippedLamps(session: SessionService, isAsked: boolean): ClippedLamps {
  // The last one is kept: devices lose the estimate for some frames.
  let contrast: number | null = null;
  /** The gain to add to the one with which the lamps were found. */
  let more = 0;
  const lamp = { clipped: 0, other: 0 };
  return {
    update: (found) => {
      if (isAsked && session.light) contrast = primaryContrast(session.light) ?? contrast;
      const strongest = found?.lamps[0];
      const clipped = found?.clipped;
      more = 0;
      if (contrast === null || !clipped || !strongest?.clippedIrradiance) return;
      lamp.clipped = luminanceOf(...strongest.clippedIrradiance);
      lamp.other = luminanceOf(...strongest.irradiance) - clipped.gain * lamp.clipped;
      more = gainOfContrast(clipped, lamp, contrast) - clipped.gain;
    },
    write: (into, { irradiance, clippedIrradiance }) => {
      for (let c = 0; c < 3; c++) into[c] = (irradiance[c] ?? 0) + more * (clippedIrradiance?.[c] ?? 0);
    },
  };
}
