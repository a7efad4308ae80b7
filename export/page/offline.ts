/**
 * Registers a service worker that stores the page's files, so that the page opens offline the next time. Without support, or if the browser
 * refuses, the page works as before.
 */
export async function keepForOffline({ navigator, location, isSecureContext }: Window, script: string): Promise<void> {
  if (!isSecureContext || !/^https?:$/.test(location.protocol)) return;
  try {
    // The scope is the folder of the page, so other pages of the host are not affected.
    await navigator.serviceWorker?.register(script, { updateViaCache: 'none' });
  } catch {
    // Fails in sandboxed frames, private windows and by a policy of the host.
  }
}
