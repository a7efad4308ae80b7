import { isObject } from '../json/shape-reader.ts';

export type JsonObject = Readonly<Record<string, unknown>>;

/** Migrates a whole document by one version. Steps are never removed, because files of every version exist. */
export type DocumentStep = (json: JsonObject) => JsonObject;

/** The format of one of the two files of a project folder. */
export interface DocumentFormat {
  readonly file: 'project.scrim.json' | 'project.layout.json';
  readonly format: 'scrim-project' | 'scrim-layout';
  /** Step `i` migrates version `i + 1` to `i + 2`, so the newest version is the number of steps plus one. */
  readonly steps: readonly DocumentStep[];
}

/** Format of the project file. Each new step needs a project of the previous version in `tests/compile/archive/`, as a test. */
export const PROJECT_FORMAT: DocumentFormat = { file: 'project.scrim.json', format: 'scrim-project', steps: [] };
export const LAYOUT_FORMAT: DocumentFormat = { file: 'project.layout.json', format: 'scrim-layout', steps: [] };

export function newestVersion(format: DocumentFormat): number {
  return format.steps.length + 1;
}

export type Migrated =
  | { readonly ok: true; readonly json: JsonObject }
  | { readonly ok: false; readonly code: 'SCR002' | 'SCR003'; readonly at: 'format' | 'version' | null; readonly message: string };

/** Migrates a document of any version to the newest. */
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
