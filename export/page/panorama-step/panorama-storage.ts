/** A panorama as it is stored on the device. */
export interface StoredPanorama {
  readonly widthPx: number;
  readonly heightPx: number;
  /** RGBA, rows from the top. */
  readonly data: Uint8ClampedArray<ArrayBuffer>;
}

/** Stores the panorama of a page on the device, and nowhere else. */
export interface PanoramaStorage {
  /** Loads the stored panorama; null if there is none, or the browser stores nothing. */
  load(): Promise<StoredPanorama | null>;
  /**
   * Stores the panorama in place of an earlier one.
   *
   * @returns Why the panorama could not be stored, as a sentence for the visitor; null if it was stored.
   */
  save(panorama: StoredPanorama): Promise<string | null>;
  forget(): Promise<void>;
}

const DATABASE = 'scrim-panoramas';
const STORE = 'panoramas';

/**
 * Creates the storage of a page.
 *
 * @param open Returns the browser's IndexedDB; throws in sandboxed frames.
 * @param page Path of the page, because all pages of an origin share its databases.
 */
export function createPanoramaStorage(open: () => IDBFactory | undefined, page: string): PanoramaStorage {
  const run = async <T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> => {
    const factory = open();
    if (!factory) throw new Error('This browser has no databases.');
    const database = await openDatabase(factory);
    try {
      const transaction = database.transaction(STORE, mode);
      const request = work(transaction.objectStore(STORE));
      await new Promise<void>((resolve, reject) => {
        transaction.oncomplete = () => resolve();
        transaction.onabort = () => reject(transaction.error ?? request.error ?? new Error('The write was aborted.'));
        transaction.onerror = () => reject(transaction.error ?? request.error ?? new Error('The write failed.'));
      });
      return request.result;
    } finally {
      database.close();
    }
  };
  return {
    load: async () => {
      try {
        const value: unknown = await run<unknown>('readonly', (store) => store.get(page));
        return isPanorama(value) ? value : null;
      } catch {
        return null;
      }
    },
    save: async ({ widthPx, heightPx, data }) => {
      try {
        await run('readwrite', (store) => store.put({ widthPx, heightPx, data }, page));
        return null;
      } catch (error) {
        const isFull = error instanceof DOMException && error.name === 'QuotaExceededError';
        return isFull
          ? 'The device has no space left for the panorama, so it is used in this visit only. Free some space, then take it again.'
          : 'This browser keeps nothing for this page, so the panorama is used in this visit only.';
      }
    },
    forget: async () => {
      await run('readwrite', (store) => store.delete(page)).catch(() => {});
    },
  };
}

function openDatabase(factory: IDBFactory): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = factory.open(DATABASE, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE);
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error('The database could not be opened.'));
    request.onblocked = () => reject(new Error('The database is in use.'));
  });
}

/** Whether a value from the database is as `save` writes it: other scripts of the origin can write to the database too. */
function isPanorama(value: unknown): value is StoredPanorama {
  if (typeof value !== 'object' || value === null) return false;
  const { widthPx, heightPx, data } = value as Partial<Record<keyof StoredPanorama, unknown>>;
  if (!Number.isInteger(widthPx) || !Number.isInteger(heightPx) || !(data instanceof Uint8ClampedArray)) return false;
  return (widthPx as number) > 0 && (heightPx as number) > 0 && data.length === (widthPx as number) * (heightPx as number) * 4;
}
