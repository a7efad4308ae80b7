import type { Capability } from '../../nodes/kit/definition.ts';
import type { ProgramNeed } from './needs.ts';

/** WebXR feature descriptor of each capability; null if WebXR has none. */
export const WEBXR_FEATURES: Readonly<Record<Capability, string | null>> = {
  'camera-image': 'camera-access',
  depth: 'depth-sensing',
  'light-estimation': 'light-estimation',
  'hit-test': 'hit-test',
  anchors: 'anchors',
  planes: 'plane-detection',
  meshes: 'mesh-detection',
  hands: 'hand-tracking',
  // The page requests these itself, outside of WebXR.
  microphone: null,
  motion: null,
  location: null,
};

export interface WebXrFeatures {
  readonly required: readonly string[];
  readonly optional: readonly string[];
}

/**
 * Features to request for a session, also listed in the export report. The floor (`local-floor`) is always optional.
 *
 * @param needs What the program needs of a session.
 * @returns Feature descriptors, in the order of the needs.
 *
 * @example
 * const { required, optional } = webXrFeatures(program.needs);
 */
export function webXrFeatures(needs: readonly ProgramNeed[]): WebXrFeatures {
  const featuresOf = (required: boolean): string[] =>
    needs.flatMap((need) => (need.required === required ? (WEBXR_FEATURES[need.capability] ?? []) : []));
  return { required: featuresOf(true), optional: ['local-floor', ...featuresOf(false)] };
}
