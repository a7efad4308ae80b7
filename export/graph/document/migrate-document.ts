import { isObject } from '../json/shape-reader.ts';

export type JsonObject = Readonly<Record<string, unknown>>;

/** Lifts a whole document by one version. It must be written down here for ever: somebody has a file of every version. */
export type DocumentStep = (json: JsonObject) => JsonObject;

/** One of the two files of a project folder. */
export interface DocumentFormat {
  readonly file: 'project.scrim.json' | 'project.layout.json';
  readonly format: 'scrim-project' | 'scrim-layout';
  /** Step `i` lifts version `i + 1` to `i + 2`, so the newest version is one more than there are steps. */
  readonly steps: readonly DocumentStep[];
}

/** Each new step brings a project of the version before it into `tests/compile/archive/`. */
export const PROJECT_FORMAT: DocumentFormat = { file: 'project.scrim.json', format: 'scrim-project', steps: [] };
export const LAYOUT_FORMAT: DocumentFormat = { file: 'project.layout.json', format: 'scrim-layout', steps: [] };

export function newestVersion(format: DocumentFormat): number {
  return format.steps.length + 1;
}

export type Migrated =
  | { readonly ok: true; readonly json: JsonObject }
  | { readonly ok: false; readonly code: 'SCR002' | 'SCR003'; readonly at: 'format' | 'version' | null; readonly message: string };

/** The document in the newest version, whatever the version it was saved in. */
export function migrateDocument(json: unknown, format: DocumentFormat): Migrated {
  if (!isObject(json)) return { ok: false, code: 'SCR002', at: null, message: 'The document is not an object.' };
  if (json.format !== format.format) {
    return { ok: false, code: 'SCR002', at: 'format', message: `The key "format" must be "${format.format}".` };
  }
  const { version } = json;
  if (typeof version !== 'number' || !Number.isInteger(version) || version < 1) {
    return { ok: false, code: 'SCR002', at: 'version', message: 'The key "version" must be a whole number from 1.' };
  }
  const newest = newestVersion(format);
  if (version > newest) {
    const message = `The file has version ${version}; this Scrim reads up to ${newest}. Open it with a newer Scrim.`;
    return { ok: false, code: 'SCR003', at: 'version', message };
  }
  let lifted: JsonObject = json;
  for (let from = version; from < newest; from++) {
    try {
      lifted = { ...format.steps[from - 1]?.(lifted), version: from + 1 };
    } catch (error) {
      const message = `The file cannot be migrated from version ${from} to ${from + 1}: ${String(error)}.`;
      return { ok: false, code: 'SCR002', at: null, message };
    }
  }
  return { ok: true, json: lifted };
}
