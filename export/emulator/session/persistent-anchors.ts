import type { XRSession } from 'iwer';
import { P_ANCHOR, P_DEVICE, P_SESSION, P_SPACE, XRAnchor, XRSpace } from 'iwer';

/**
 * Anchors that the device keeps after a session, by handle: their places in the room. They outlive the page where it has storage, as on a
 * Quest. They replace iwer's persistent anchors, which have no limit, are tracked in each session without being restored, and fail in pages
 * without storage.
 */
export interface PersistentAnchors {
  readonly handles: readonly string[];
  /**
   * Stores an anchor.
   *
   * @returns The handle, which is the same each time for the same anchor.
   * @throws DOMException InvalidStateError if the anchor is deleted, UnknownError if the limit is reached, NotSupportedError if the device
   * keeps no anchors.
   */
  keep(anchor: XRAnchor): string;
  /** @throws DOMException InvalidStateError if there is no anchor with this handle. */
  restore(handle: string, session: XRSession): XRAnchor;
  /** @throws DOMException InvalidStateError if there is no anchor with this handle. */
  delete(handle: string): void;
  /** Deletes all anchors, as when the visitor clears the data of the device. */
  clear(): void;
}

const KEY = 'scrim-emulator/persistent-anchors';

/** @param limit How many the device keeps; 0 for one that keeps none. */
export function createPersistentAnchors(limit: number): PersistentAnchors {
  const worldFromAnchors = new Map<string, readonly number[]>(load());
  const handleOf = new WeakMap<XRAnchor, string>();
  const save = (): void => storage()?.setItem(KEY, JSON.stringify([...worldFromAnchors]));
  const placeOf = (handle: string): readonly number[] => {
    const place = worldFromAnchors.get(handle);
    if (!place) throw new DOMException(`There is no persistent anchor "${handle}".`, 'InvalidStateError');
    return place;
  };
  return {
    get handles() {
      return [...worldFromAnchors.keys()];
    },
    keep: (anchor) => {
      if (limit === 0) throw new DOMException('The device keeps no anchors.', 'NotSupportedError');
      const { deleted, anchorSpace } = anchor[P_ANCHOR];
      if (deleted || !anchorSpace) throw new DOMException('The anchor has been deleted.', 'InvalidStateError');
      const known = handleOf.get(anchor);
      if (known !== undefined && worldFromAnchors.has(known)) return known;
      // The words of Quest Browser.
      if (worldFromAnchors.size >= limit) throw new DOMException('Anchor creation failed.', 'UnknownError');
      const handle = crypto.randomUUID();
      handleOf.set(anchor, handle);
      worldFromAnchors.set(handle, Array.from(anchorSpace[P_SPACE].offsetMatrix));
      save();
      return handle;
    },
    restore: (handle, session) => {
      const { globalSpace } = session[P_SESSION].device[P_DEVICE];
      const anchor = new XRAnchor(new XRSpace(globalSpace, new Float32Array(placeOf(handle))), session);
      handleOf.set(anchor, handle);
      return anchor;
    },
    delete: (handle) => {
      placeOf(handle);
      worldFromAnchors.delete(handle);
      save();
    },
    clear: () => {
      worldFromAnchors.clear();
      save();
    },
  };
}

function load(): [string, readonly number[]][] {
  try {
    return JSON.parse(storage()?.getItem(KEY) ?? '[]') as [string, readonly number[]][];
  } catch {
    return [];
  }
}

/** `localStorage`; null in pages without storage, such as sandboxed frames. */
function storage(): Storage | null {
  try {
    return globalThis.localStorage;
  } catch {
    return null;
  }
}
