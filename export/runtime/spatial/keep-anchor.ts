import type { AnchorMemory, KeptAnchor } from './anchor-memory.ts';

/** Number of anchors that a Quest keeps per origin. It refuses further ones until one is deleted. */
export const KEPT_LIMIT = 8;

/** The result of `keepAnchor`. */
export interface Kept {
  readonly kept: boolean;
  /** Number of older anchors that were deleted to make room. */
  readonly evicted: number;
}

/**
 * Asks the device to keep an anchor after the session (WebXR Anchors, “persistent anchors”, as of Quest Browser 31). If the device can keep
 * no more anchors, the oldest one of this origin is deleted to make room.
 *
 * @param name Name of the anchor. An earlier anchor of that name is replaced.
 * @returns Never rejects.
 */
export async function keepAnchor(
  anchor: XRAnchor,
  session: XRSession,
  memory: AnchorMemory,
  { name, anchorFromPose }: Omit<KeptAnchor, 'page' | 'handle'>,
): Promise<Kept> {
  const former = memory.find(name);
  if (former) await forgetAnchor(session, memory, former);
  let evicted = 0;
  for (;;) {
    const handle = await requestHandle(anchor);
    if (handle !== null) {
      memory.add({ name, handle, anchorFromPose });
      return { kept: true, evicted };
    }
    const oldest = memory.count >= KEPT_LIMIT ? memory.oldest() : null;
    if (!oldest) return { kept: false, evicted };
    await forgetAnchor(session, memory, oldest);
    evicted++;
  }
}

/** Deletes a kept anchor from the device and from the memory. Never rejects. */
export async function forgetAnchor(session: XRSession, memory: AnchorMemory, { handle }: KeptAnchor): Promise<void> {
  memory.remove(handle);
  try {
    await session.deletePersistentAnchor?.(handle);
  } catch {
    // The device has forgotten it already, or the session ended.
  }
}

/** Requests the handle by which the browser finds the anchor again; null if the browser cannot keep anchors, or refuses. */
async function requestHandle(anchor: XRAnchor): Promise<string | null> {
  try {
    return (await anchor.requestPersistentHandle?.()) ?? null;
  } catch {
    return null;
  }
}
