import type { Editor } from '../editor/editor.ts';
import { chosenSource, type FrameRange } from '../editor/preview-state.ts';

/** The last play range of a recording in a project. */
interface Kept {
  readonly range: FrameRange | null;
  readonly loop: boolean;
}

const KEY = 'scrim-ranges';
/** Maximum number of stored ranges; the oldest are dropped. */
const MOST = 200;
const NOTHING: Kept = { range: null, loop: false };

/** Restores the play range of a project and source when they open, and stores its changes. */
export function keepRanges(editor: Pick<Editor, 'document' | 'preview'>, storage: Pick<Storage, 'getItem' | 'setItem'>): () => void {
  const { document, preview } = editor;
  const kept = new Map(readAll(storage));
  let shown: string | null = null;

  const keep = (key: string) => {
    const { range, loop } = preview.getState();
    kept.delete(key);
    kept.set(key, { range, loop });
    for (const oldest of kept.keys()) if (kept.size > MOST) kept.delete(oldest);
    storage.setItem(KEY, JSON.stringify([...kept]));
  };
  /** `sameWork`: the project was saved as a copy and keeps its state. */
  const follow = (sameWork: boolean) => {
    const path = document.getState().open?.displayPath;
    const source = chosenSource(preview.getState())?.id;
    const key = path === undefined || source === undefined ? null : `${source} ${path}`;
    if (key === shown) return;
    shown = key;
    if (key === null) return;
    if (sameWork && !kept.has(key)) keep(key);
    else preview.setState(kept.get(key) ?? NOTHING);
  };
  const stopDocument = document.subscribe((state, before) => {
    if (state.open !== before.open) follow(state.project === before.project && before.open !== null);
  });
  const stopPreview = preview.subscribe((state, before) => {
    if (state.sources !== before.sources || state.sourceId !== before.sourceId) follow(false);
    if (shown !== null && (state.range !== before.range || state.loop !== before.loop) && !isKept(kept.get(shown), state)) keep(shown);
  });
  return () => {
    stopDocument();
    stopPreview();
  };
}

function isKept(kept: Kept | undefined, { range, loop }: Kept): boolean {
  const { range: before, loop: looped } = kept ?? NOTHING;
  return before?.from === range?.from && before?.to === range?.to && looped === loop;
}

function readAll(storage: Pick<Storage, 'getItem'>): [string, Kept][] {
  try {
    const saved: unknown = JSON.parse(storage.getItem(KEY) ?? '[]');
    return Array.isArray(saved) ? saved.filter(isEntry) : [];
  } catch {
    // Invalid JSON: there is nothing to restore.
    return [];
  }
}

function isEntry(value: unknown): value is [string, Kept] {
  if (!Array.isArray(value) || typeof value[0] !== 'string') return false;
  const { range, loop } = (value[1] ?? {}) as Partial<Kept>;
  const isFrame = (frame: unknown) => Number.isInteger(frame) && (frame as number) >= 0;
  return (
    typeof loop === 'boolean' &&
    (range === null || (isFrame(range?.from) && isFrame(range?.to) && Number(range?.from) <= Number(range?.to)))
  );
}
