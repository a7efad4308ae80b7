/** Why AR cannot be entered here, for people: null where it can. */
export type ArSupport = 'supported' | 'insecure' | 'no-webxr' | 'no-ar';

export const NO_AR: Readonly<Record<Exclude<ArSupport, 'supported'>, string>> = {
  insecure: 'AR needs a secure address: open this page with https.',
  'no-webxr': 'This browser has no AR. Open the page in Chrome on an Android phone, or in a headset’s browser, to see it in your room.',
  'no-ar': 'This device offers no AR. Open the page on an Android phone or a headset to see it in your room.',
};

/** Asks the browser. Nothing is requested of the visitor yet. */
export async function findArSupport(page: {
  readonly isSecureContext: boolean;
  readonly navigator: { readonly xr?: XRSystem };
}): Promise<ArSupport> {
  const { xr } = page.navigator;
  if (!xr) return page.isSecureContext ? 'no-webxr' : 'insecure';
  return xr.isSessionSupported('immersive-ar').then(
    (supported) => (supported ? 'supported' : 'no-ar'),
    () => 'no-ar',
  );
}

/** What to tell the visitor when entering AR failed. */
export function refusalText(error: unknown): string {
  const name = typeof error === 'object' && error !== null && 'name' in error ? error.name : '';
  switch (name) {
    case 'NotAllowedError':
      return 'AR was not allowed. Allow it in the browser’s settings for this page, then try again.';
    case 'NotSupportedError':
      return 'This device cannot give what the page needs for AR.';
    case 'SecurityError':
      return 'The page may not use AR where it is shown. Open it in a tab of its own.';
    case 'InvalidStateError':
      return 'Another page is using AR. Close it, then try again.';
    default:
      return `AR could not be entered${error instanceof Error && error.message !== '' ? `: ${error.message}` : '.'}`;
  }
}
