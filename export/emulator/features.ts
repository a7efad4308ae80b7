import type { DepthFormat, DepthProfile, DepthUsage } from './profiles.ts';

/** The members of `XRSessionInit` that decide what a session gets. */
export interface SessionWishes {
  readonly requiredFeatures?: readonly string[];
  readonly optionalFeatures?: readonly string[];
  readonly depthSensing?: DepthWishes;
  readonly domOverlay?: { readonly root?: Element | null };
}

export interface DepthWishes {
  readonly usagePreference?: readonly string[];
  readonly dataFormatPreference?: readonly string[];
  /** Whether depth is reprojected to the current view; otherwise it comes with the depth camera's own pose. Default: true. */
  readonly matchDepthView?: boolean;
}

export interface DepthConfiguration {
  readonly usage: DepthUsage;
  readonly format: DepthFormat;
  readonly matchView: boolean;
}

export type Grant =
  | { readonly features: readonly string[]; readonly depth: DepthConfiguration | null }
  /** A required feature that the device does not support. */
  | { readonly missing: string };

/** Features that every immersive session has (WebXR Device API, “default features”). */
const DEFAULT_FEATURES = ['viewer', 'local'];

/** Resolves the requested features: WebXR Device API §5.2. */
export function grantFeatures(wishes: SessionWishes, supported: ReadonlySet<string>, depthProfile: DepthProfile): Grant {
  const depth = wishes.depthSensing ? chooseDepth(wishes.depthSensing, depthProfile) : null;
  const canHave = (feature: string): boolean => {
    if (!supported.has(feature)) return false;
    if (feature === 'depth-sensing') return depth !== null;
    if (feature === 'dom-overlay') return wishes.domOverlay?.root instanceof Element;
    return true;
  };
  const required = wishes.requiredFeatures ?? [];
  const missing = required.find((feature) => !canHave(feature));
  if (missing !== undefined) return { missing };
  const optional = (wishes.optionalFeatures ?? []).filter(canHave);
  const features = [...new Set([...DEFAULT_FEATURES, ...required, ...optional])];
  return { features, depth: features.includes('depth-sensing') ? depth : null };
}

/**
 * “Find supported configuration combination” of WebXR Depth Sensing §2.3. A single preference is used as is; of several, the first
 * supported one; without preferences, the device's first. Returns null if the device does not support the result.
 */
export function chooseDepth(wishes: DepthWishes, profile: DepthProfile): DepthConfiguration | null {
  const usage = choose(wishes.usagePreference ?? [], profile.usages);
  const format = choose(wishes.dataFormatPreference ?? [], profile.formats);
  return usage && format ? { usage, format, matchView: wishes.matchDepthView ?? true } : null;
}

/** Chooses the usage or the format of depth. Every usage of a profile works with every format, so the two are chosen independently. */
function choose<T extends string>(preferences: readonly string[], supported: readonly T[]): T | undefined {
  if (preferences.length === 0) return supported[0];
  const wished = preferences.find((preference) => supported.some((value) => value === preference));
  return supported.find((value) => value === wished);
}
