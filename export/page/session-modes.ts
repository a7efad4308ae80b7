import type { Tier } from '../program/needs.ts';
import { supportsWebXr } from '../runtime/sessions/webxr/request-session.ts';

/** Session modes that a visitor can enter. The orbit view is the initial state. */
export type SessionMode = 'ar' | 'camera' | 'vr';

/** The parts of a browser window that are read. Tests pass their own. */
export interface ModePage {
  readonly isSecureContext: boolean;
  readonly navigator: { readonly xr?: XRSystem | undefined; readonly mediaDevices?: MediaDevices | undefined };
}

export interface SessionModes {
  /** Modes to offer, best first; empty if only the orbit view works. */
  readonly offers: readonly SessionMode[];
  /** Modes to offer after the best one was refused, best first. Includes the refused one, for another try. */
  readonly fallbacks: readonly SessionMode[];
  /** Why AR is not available here, as text for visitors; null if it is. */
  readonly noAr: string | null;
}

/** What the page says if the script of the sessions did not load. */
export const NOT_LOADED = 'The page did not load completely, so AR and the camera are missing. Check the connection, then reload the page.';

/** Finds the session modes that this browser and device support. Requests no permission. */
export async function findSessionModes(page: ModePage, tiers: readonly Tier[]): Promise<SessionModes> {
  const noAr = await noArReason(page);
  const others: SessionMode[] = [];
  if (canUseCamera(page, tiers)) others.push('camera');
  // Below the camera, because phones without AR support VR too, for use in a cardboard viewer.
  if (tiers.some(({ id }) => id === 'authored-vr') && (await supportsWebXr(page.navigator.xr, 'immersive-vr'))) others.push('vr');
  return noAr === null ? { offers: ['ar'], fallbacks: ['ar', ...others], noAr } : { offers: others, fallbacks: others, noAr };
}

/** Whether the program can be played in a camera session and the browser can provide the camera image. */
function canUseCamera({ navigator }: ModePage, tiers: readonly Tier[]): boolean {
  return typeof navigator.mediaDevices?.getUserMedia === 'function' && tiers.some(({ id }) => id === 'camera');
}

async function noArReason({ isSecureContext, navigator }: ModePage): Promise<string | null> {
  if (!isSecureContext) return 'AR needs a secure address. Open this page with https.';
  if (!navigator.xr) {
    return 'This browser has no AR. Open the page in Chrome on an Android phone, or in a headset’s browser, to see it in your room.';
  }
  if (await supportsWebXr(navigator.xr)) return null;
  return 'This device offers no AR. Many Android phones and headsets show the page in your room.';
}

/** Returns what is missing in a tier, as sentences for visitors. */
export function lacksOf(tiers: readonly Tier[], id: Tier['id']): readonly string[] {
  const tier = tiers.find((candidate) => candidate.id === id);
  return [...new Set((tier?.without ?? []).map(({ effect }) => sentence(effect)))];
}

/** Makes a sentence of a text: `to hide objects` → `To hide objects.` */
function sentence(text: string): string {
  const bare = text.trim().replace(/[.\s]+$/, '');
  return `${bare.charAt(0).toUpperCase()}${bare.slice(1)}.`;
}
