import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { ProgramNeed } from '../../../program/program.ts';

/** Feature descriptor of each capability. */
const FEATURES: Readonly<Record<Capability, string | null>> = {
  'camera-image': 'camera-access',
  depth: 'depth-sensing',
  'light-estimation': 'light-estimation',
  'hit-test': 'hit-test',
  anchors: 'anchors',
  planes: 'plane-detection',
  meshes: 'mesh-detection',
  hands: 'hand-tracking',
  // The page asks for it by itself.
  microphone: null,
};

/**
 * CPU first: phones give 160 × 90 samples, quickly copied, and headsets that have the GPU's alone take the second wish. Smooth,
 * because noise shows as a flickering border. `matchDepthView` is the default: depth as the view sees it.
 */
const DEPTH_WISHES: XRDepthStateInit = {
  usagePreference: ['cpu-optimized', 'gpu-optimized'],
  dataFormatPreference: ['luminance-alpha', 'float32', 'unsigned-short'],
  depthTypeRequest: ['smooth', 'raw'],
};

/** Asks for what the program needs and nothing else; the floor is welcome and not needed. */
export function sessionInit(needs: readonly ProgramNeed[], overlayRoot: Element | null): XRSessionInit {
  const features = (required: boolean): string[] =>
    needs.flatMap(({ required: isRequired, capability }) => (isRequired === required ? (FEATURES[capability] ?? []) : []));
  const wantsDepth = needs.some((need) => need.capability === 'depth');
  return {
    requiredFeatures: features(true),
    optionalFeatures: ['local-floor', ...features(false), ...(overlayRoot ? ['dom-overlay'] : [])],
    ...(wantsDepth ? { depthSensing: DEPTH_WISHES } : {}),
    ...(overlayRoot ? { domOverlay: { root: overlayRoot } } : {}),
  };
}

/** What of the needs was granted. Browsers without `enabledFeatures` are taken at their word: what they accepted they have. */
export function grantedCapabilities(session: XRSession, needs: readonly ProgramNeed[]): ReadonlySet<Capability> {
  const enabled = session.enabledFeatures;
  const isGranted = (feature: string | null): boolean => !enabled || feature === null || enabled.includes(feature);
  return new Set(needs.map((need) => need.capability).filter((capability) => isGranted(FEATURES[capability])));
}
