import type { Editor } from '../editor/editor.ts';
import { DEFAULT_EXPORT_SETTINGS, type ExportSettings } from '../editor/ui.ts';

const KEY = 'scrim-exports';
/** Maximum number of stored settings; the oldest are dropped. */
const MOST = 200;

/** Restores the export settings of a project when it opens, and stores their changes. */
export function keepExports({ document, ui }: Pick<Editor, 'document' | 'ui'>, storage: Pick<Storage, 'getItem' | 'setItem'>): () => void {
  const kept = new Map(readAll(storage));
  let path: string | null = null;
  const stops = [
    document.subscribe(({ open }, before) => {
      if (open === before.open || open?.displayPath === path) return;
      path = open?.displayPath ?? null;
      const settings = path === null || open?.isNew ? undefined : kept.get(path);
      ui.setState({ exportSettings: settings ?? DEFAULT_EXPORT_SETTINGS, exportErrors: [] });
    }),
    ui.subscribe(({ exportSettings }, before) => {
      if (path === null || exportSettings === before.exportSettings || exportSettings === kept.get(path)) return;
      kept.delete(path);
      kept.set(path, exportSettings);
      for (const oldest of kept.keys()) if (kept.size > MOST) kept.delete(oldest);
      storage.setItem(KEY, JSON.stringify([...kept]));
    }),
  ];
  return () => {
    for (const stop of stops) stop();
  };
}

function readAll(storage: Pick<Storage, 'getItem'>): [string, ExportSettings][] {
  try {
    const saved: unknown = JSON.parse(storage.getItem(KEY) ?? '[]');
    return Array.isArray(saved) ? saved.filter(isEntry) : [];
  } catch {
    // Invalid JSON: there is nothing to restore.
    return [];
  }
}

function isEntry(value: unknown): value is [string, ExportSettings] {
  if (!Array.isArray(value) || typeof value[0] !== 'string') return false;
  const { out, singleFile, offline, address } = (value[1] ?? {}) as Partial<ExportSettings>;
  return typeof out === 'string' && typeof singleFile === 'boolean' && typeof offline === 'boolean' && typeof address === 'string';
}
