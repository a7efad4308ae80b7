import type { Pointer, XrAccess } from '../../../nodes/kit/session.ts';

/** The device's hit test for one `HitTest`. Its hit-test sources are requested when they are first needed. */
export interface WebXrHits {
  /** Results of this frame along the viewer's ray; empty until the device has granted the source. */
  ofViewer(xr: XrAccess): readonly XRHitTestResult[];
  /** Results of this frame along a pointer's ray; empty until the device has granted the source. */
  ofPointer(xr: XrAccess, pointer: Pointer): readonly XRHitTestResult[];
  /**
   * Closes the hit-test sources of input sources that no longer exist. Called once per frame, after the results were read. With
   * `expectsTouch`, also requests the source for fingers, before the first touch.
   */
  sweep(xr: XrAccess, expectsTouch: boolean): void;
  close(): void;
}

/** Counts of a player's requests to the device. */
export interface WebXrLedger {
  /** Number of hit-test sources that the device holds. */
  sources: number;
  /** Number of requests that the device has not answered yet. */
  pending: number;
}

interface Entry {
  source: XRHitTestSource | XRTransientInputHitTestSource | null;
  closed: boolean;
}

const NO_RESULTS: readonly XRHitTestResult[] = [];
/** Profile of fingers on the screen (WebXR Hit Test §6.2 and the registry of profiles). */
const TOUCH_PROFILE = 'generic-touchscreen';
const VIEWER = 'viewer';
const TOUCH = 'touch';

export function createWebXrHits(ledger: WebXrLedger, offsetRay: ArrayLike<number> | null): WebXrHits {
  const entries = new Map<unknown, Entry>();
  let session: object | null = null;
  const ray = offsetRay && (() => toXrRay(offsetRay));

  function open(key: unknown, request: () => Promise<XRHitTestSource | XRTransientInputHitTestSource> | undefined): Entry {
    const entry: Entry = { source: null, closed: false };
    entries.set(key, entry);
    ledger.pending++;
    void requested(request)
      .then((source) => {
        if (!source) return;
        ledger.sources++;
        entry.source = source;
        if (entry.closed) cancel(entry);
      })
      // Refused: the other sources answer.
      .catch(() => {})
      .finally(() => {
        ledger.pending--;
      });
    return entry;
  }
  function cancel(entry: Entry): void {
    entry.closed = true;
    if (!entry.source) return;
    ledger.sources--;
    try {
      entry.source.cancel();
    } catch {
      // The session ended, and the source with it.
    }
    entry.source = null;
  }
  const closeAll = (): void => {
    for (const entry of entries.values()) cancel(entry);
    entries.clear();
  };
  /** Closes the sources if they belong to an earlier session, with which they have ended. */
  const enter = (xr: XrAccess): void => {
    if (session !== xr.session) closeAll();
    session = xr.session;
  };
  /** Results along the ray of an input source; null: of the viewer. */
  const alongSpace = (xr: XrAccess, source: XRInputSource | null): readonly XRHitTestResult[] => {
    enter(xr);
    const entry = entries.get(source ?? VIEWER) ?? openAlong(xr.session as XRSession, source);
    return entry.source ? (xr.frame as XRFrame).getHitTestResults(entry.source as XRHitTestSource) : NO_RESULTS;
  };
  const openAlong = (xrSession: XRSession, source: XRInputSource | null): Entry =>
    open(source ?? VIEWER, async () => {
      const offset = ray?.();
      const space = source ? source.targetRaySpace : await xrSession.requestReferenceSpace('viewer');
      return xrSession.requestHitTestSource?.({ space, ...(offset ? { offsetRay: offset } : {}) }) as Promise<XRHitTestSource>;
    });
  const openTouch = (xrSession: XRSession): Entry =>
    open(TOUCH, () => xrSession.requestHitTestSourceForTransientInput?.({ profile: TOUCH_PROFILE }));
  // Made once: the map is walked in every frame.
  const dropGone = (entry: Entry, key: unknown): void => {
    if (key === VIEWER || key === TOUCH) return;
    const { inputSources } = session as XRSession;
    for (let i = 0; i < inputSources.length; i++) if (inputSources[i] === key) return;
    cancel(entry);
    entries.delete(key);
  };
  return {
    ofViewer: (xr) => alongSpace(xr, null),
    ofPointer: (xr, pointer) => {
      const source = pointer.xrSource as XRInputSource | null;
      if (!source) return NO_RESULTS;
      if (pointer.by !== 'screen') return alongSpace(xr, source);
      enter(xr);
      const entry = entries.get(TOUCH) ?? openTouch(xr.session as XRSession);
      if (!entry.source) return NO_RESULTS;
      const all = (xr.frame as XRFrame).getHitTestResultsForTransientInput(entry.source as XRTransientInputHitTestSource);
      for (let i = 0; i < all.length; i++) if (all[i]?.inputSource === source) return all[i]?.results ?? NO_RESULTS;
      return NO_RESULTS;
    },
    sweep: (xr, expectsTouch) => {
      enter(xr);
      // Asked for before the first touch, because the device answers later.
      if (expectsTouch && !entries.has(TOUCH)) openTouch(xr.session as XRSession);
      entries.forEach(dropGone);
    },
    close: closeAll,
  };
}

/** Calls `request` so that an exception becomes a rejection. Resolves to undefined if the browser has no such method. */
async function requested<T>(request: () => Promise<T> | undefined): Promise<T | undefined> {
  return request();
}

function toXrRay(m: ArrayLike<number>): XRRay {
  const at = (i: number): number => m[i] ?? 0;
  return new XRRay({ x: at(12), y: at(13), z: at(14), w: 1 }, { x: -at(8), y: -at(9), z: -at(10), w: 0 });
}
