import type { Tier } from '../program/program.ts';
import { supportsWebXr } from '../runtime/sessions/webxr/request-session.ts';

/** What a visitor can enter; looking around needs no entering. */
export type Way = 'ar' | 'camera' | 'vr';

/** What is asked of a browser window; a test brings its own. */
export interface WayPage {
  readonly isSecureContext: boolean;
  readonly navigator: { readonly xr?: XRSystem | undefined; readonly mediaDevices?: MediaDevices | undefined };
}

export interface Ways {
  /** Best first; none where the page can only be looked at. */
  readonly offers: readonly Way[];
  /** Why AR cannot be entered here, for people, or null where it can. */
  readonly noAr: string | null;
}

/** What this browser and device can give of the program's tiers. Nothing is requested of the visitor yet. */
export async function findWays(page: WayPage, tiers: readonly Tier[]): Promise<Ways> {
  const noAr = await noArReason(page);
  const offers: Way[] = [];
  if (noAr === null) offers.push('ar');
  if (noAr !== null && canUseCamera(page, tiers)) offers.push('camera');
  // After the camera, because phones without AR have VR too, for those who put them into a box.
  if (noAr !== null && tiers.some(({ id }) => id === 'authored-vr') && (await supportsWebXr(page.navigator.xr, 'immersive-vr'))) {
    offers.push('vr');
  }
  return { offers, noAr };
}

/** Whether the program has a use for the camera, and the browser a way to it. */
export function canUseCamera({ navigator }: WayPage, tiers: readonly Tier[]): boolean {
  return typeof navigator.mediaDevices?.getUserMedia === 'function' && tiers.some(({ id }) => id === 'camera');
}

async function noArReason({ isSecureContext, navigator }: WayPage): Promise<string | null> {
  if (!isSecureContext) return 'AR needs a secure address: open this page with https.';
  if (!navigator.xr) {
    return 'This browser has no AR. Open the page in Chrome on an Android phone, or in a headset’s browser, to see it in your room.';
  }
  if (await supportsWebXr(navigator.xr)) return null;
  return 'This device offers no AR. Open the page on an Android phone or a headset to see it in your room.';
}

/** What the picture does without the capabilities that a tier lacks, as sentences. */
export function lacksOf(tiers: readonly Tier[], id: Tier['id']): readonly string[] {
  const tier = tiers.find((candidate) => candidate.id === id);
  return [...new Set((tier?.without ?? []).map(({ effect }) => sentence(effect)))];
}

/** `to hide things` → `To hide things.` */
function sentence(text: string): string {
  const bare = text.trim().replace(/[.\s]+$/, '');
  return `${bare.charAt(0).toUpperCase()}${bare.slice(1)}.`;
}
