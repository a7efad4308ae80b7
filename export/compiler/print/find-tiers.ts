import type { Capability } from '../../../nodes/kit/definition.ts';
import { isFixedImage } from '../../program/fixed-image.ts';
import type { Tier } from '../../program/needs.ts';
import type { Program } from '../../program/program.ts';

/** Capabilities that the page itself requests, so that they are available in any kind of session. */
const OF_THE_PAGE: readonly Capability[] = ['microphone', 'motion', 'location'];

/** Capabilities of each kind of session, best first (docs/ARCHITECTURE.md, “Sessions”; devices: WebXR implementations of 2026). */
const TIERS: readonly { readonly id: Tier['id']; readonly offers: readonly Capability[] }[] = [
  {
    id: 'ar-camera',
    offers: ['camera-image', 'depth', 'light-estimation', 'hit-test', 'anchors', 'planes', 'meshes', 'hands', ...OF_THE_PAGE],
  },
  { id: 'ar', offers: ['depth', 'light-estimation', 'hit-test', 'anchors', 'planes', 'meshes', 'hands', ...OF_THE_PAGE] },
  { id: 'camera', offers: ['camera-image', ...OF_THE_PAGE] },
  // The authored room replaces the camera image.
  { id: 'authored-vr', offers: ['camera-image', 'hands', ...OF_THE_PAGE] },
  { id: 'orbit', offers: [...OF_THE_PAGE] },
];

/**
 * The tiers that can play the program, with what each lacks. Tiers with the camera image are listed only if the program uses that image.
 * Tiers that lack a required capability are left out, except orbit, which needs no permission. A program that shows the same image in all
 * of them plays in orbit alone.
 */
export function findTiers(program: Omit<Program, 'tiers'>): Tier[] {
  const {
    needs,
    presentation: { background },
  } = program;
  if (isFixedImage(program)) return [{ id: 'orbit', without: [] }];
  const samplesCamera = needs.some(({ capability }) => capability === 'camera-image');
  return TIERS.flatMap(({ id, offers }): Tier[] => {
    if (id === 'ar-camera' && !samplesCamera) return [];
    if (id === 'camera' && !samplesCamera && background !== 'world') return [];
    const missing = needs.filter(({ capability }) => !offers.includes(capability));
    if (id !== 'orbit' && missing.some(({ required }) => required)) return [];
    return [{ id, without: missing.map(({ capability, without }) => ({ capability, effect: without })) }];
  });
}
