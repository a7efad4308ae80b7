import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { ProgramNeed } from '../../../program/needs.ts';
import { WEBXR_FEATURES, webXrFeatures } from '../../../program/webxr-features.ts';

/**
 * Options of room depth. CPU first: phones give 160 × 90 samples, which are fast to copy. Headsets that only have GPU depth use the second
 * preference. `matchDepthView` keeps its default, depth aligned with the view.
 */
const DEPTH_PREFERENCES: XRDepthStateInit = {
  usagePreference: ['cpu-optimized', 'gpu-optimized'],
  dataFormatPreference: ['luminance-alpha', 'float32', 'unsigned-short'],
};

/** Smooth first for occlusion, where noise causes flickering borders; raw first where all readers measure. */
const SMOOTH_FIRST = ['smooth', 'raw'] as const;
const RAW_FIRST = ['raw', 'smooth'] as const;

/**
 * The options of `requestSession`: what the program needs and nothing else, with the floor as an optional feature.
 *
 * @param needs What the program needs of the session.
 * @param overlayRoot Page element that a handheld device shows over the camera feed; null for none.
 */
export function sessionInit(needs: readonly ProgramNeed[], overlayRoot: Element | null): XRSessionInit {
  const { required, optional } = webXrFeatures(needs);
  const depth = needs.find((need) => need.capability === 'depth');
  return {
    requiredFeatures: [...required],
    optionalFeatures: [...optional, ...(overlayRoot ? ['dom-overlay'] : [])],
    ...(depth
      ? { depthSensing: { ...DEPTH_PREFERENCES, depthTypeRequest: [...(depth.depthType === 'raw' ? RAW_FIRST : SMOOTH_FIRST)] } }
      : {}),
    ...(overlayRoot ? { domOverlay: { root: overlayRoot } } : {}),
  };
}

/**
 * The needs that the session granted.
 *
 * @returns Capabilities in the order of the needs; all of them where the browser does not implement `enabledFeatures`.
 */
export function grantedCapabilities(session: XRSession, needs: readonly ProgramNeed[]): ReadonlySet<Capability> {
  const enabled = session.enabledFeatures;
  const isGranted = (feature: string | null): boolean => !enabled || feature === null || enabled.includes(feature);
  return new Set(needs.map((need) => need.capability).filter((capability) => isGranted(WEBXR_FEATURES[capability])));
}
