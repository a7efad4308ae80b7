/**
 * Lets a service worker keep the page's files, so that it opens without a connection from the next time on. Only where the page
 * comes from a host that may have one; where it has none, or the browser refuses, the page works as before.
 */
export async function keepForOffline({ navigator, location, isSecureContext }: Window, script: string): Promise<void> {
  if (!isSecureContext || !/^https?:$/.test(location.protocol)) return;
  try {
    // Its folder is its scope: other pages of the same host are none of its business.
    await navigator.serviceWorker?.register(script, { updateViaCache: 'none' });
  } catch {
    // A sandboxed frame, a private window, a policy of the host.
  }
}
