import type { Capability, ProgramNeed } from '../program/program.ts';

/** Feature descriptors as the page's session asks for them; a test compares the two. */
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

export interface WebXrFeatures {
  readonly required: readonly string[];
  readonly optional: readonly string[];
}

/** What entering AR asks the browser for. The floor is always welcome. */
export function webXrFeatures(needs: readonly ProgramNeed[]): WebXrFeatures {
  const some = (required: boolean) =>
    needs.flatMap(({ required: isRequired, capability }) => (isRequired === required ? (FEATURES[capability] ?? []) : []));
  return { required: some(true), optional: ['local-floor', ...some(false)] };
}
