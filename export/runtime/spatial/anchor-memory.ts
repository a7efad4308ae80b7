/** The part of `Storage` that kept anchors and files need. */
export type KeptStorage = Pick<Storage, 'getItem' | 'setItem' | 'removeItem'>;
/** The part of `Storage` that kept anchors need. */
export type AnchorStorage = Pick<Storage, 'getItem' | 'setItem'>;

/** An anchor that the device keeps after the session. */
export interface KeptAnchor {
  /** The page that keeps the anchor, as its path on the origin. */
  readonly page: string;
  /** Name of the anchor, unique within the page. */
  readonly name: string;
  /** The device's handle of the anchor. */
  readonly handle: string;
  /** The kept pose in the space of the device's anchor, column-major 4×4; null if both poses are the same. */
  readonly anchorFromPose: readonly number[] | null;
}

/** Stores which anchors the pages of an origin keep, oldest first. */
export interface AnchorMemory {
  find(name: string): KeptAnchor | null;
  /** The oldest anchor of all pages of the origin, because they share the device's limit; null if there are none. */
  oldest(): KeptAnchor | null;
  readonly count: number;
  add(kept: Omit<KeptAnchor, 'page'>): void;
  remove(handle: string): void;
}

const KEY = 'scrim-kept-anchors';

/**
 * Creates the memory of the anchors that a page keeps.
 *
 * @param storage Where anchors are stored. If it is null or throws, as in private windows, anchors are known only until the page is closed.
 * @param page Path of the page.
 */
export function createAnchorMemory(storage: AnchorStorage | null, page: string): AnchorMemory {
  let unsaved: readonly KeptAnchor[] = [];
  // Read each time: another page of the origin may have changed it.
  const read = (): readonly KeptAnchor[] => {
    try {
      const text = storage?.getItem(KEY);
      if (text === null || text === undefined) return unsaved;
      const parsed: unknown = JSON.parse(text);
      return Array.isArray(parsed) ? parsed.filter(isKept) : [];
    } catch {
      return unsaved;
    }
  };
  const write = (list: readonly KeptAnchor[]): void => {
    unsaved = list;
    try {
      storage?.setItem(KEY, JSON.stringify(list));
    } catch {
      // The storage is full or refused.
    }
  };
  return {
    find: (name) => read().find((kept) => kept.page === page && kept.name === name) ?? null,
    oldest: () => read()[0] ?? null,
    get count() {
      return read().length;
    },
    add: (kept) => write([...read(), { ...kept, page }]),
    remove: (handle) => write(read().filter((kept) => kept.handle !== handle)),
  };
}

/** Whether a value from the storage is as `add` writes it: other scripts of the origin can write to the storage too. */
function isKept(value: unknown): value is KeptAnchor {
  if (typeof value !== 'object' || value === null) return false;
  const { page, name, handle, anchorFromPose } = value as Partial<Record<keyof KeptAnchor, unknown>>;
  const isMatrix = Array.isArray(anchorFromPose) && anchorFromPose.length === 16 && anchorFromPose.every(Number.isFinite);
  return [page, name, handle].every((text) => typeof text === 'string') && (anchorFromPose === null || isMatrix);
}
