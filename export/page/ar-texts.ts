import { supportsWebXr } from '../runtime/sessions/webxr/request-session.ts';

/** What is asked of a browser window; a test brings its own. */
export interface ArPage {
  readonly isSecureContext: boolean;
  readonly navigator: { readonly xr?: XRSystem | undefined };
}

/** Why AR cannot be entered here, for people, or null where it can. Nothing is requested of the visitor yet. */
export async function noArReason({ isSecureContext, navigator }: ArPage): Promise<string | null> {
  if (!isSecureContext) return 'AR needs a secure address: open this page with https.';
  if (!navigator.xr) {
    return 'This browser has no AR. Open the page in Chrome on an Android phone, or in a headset’s browser, to see it in your room.';
  }
  if (await supportsWebXr(navigator.xr)) return null;
  return 'This device offers no AR. Open the page on an Android phone or a headset to see it in your room.';
}
