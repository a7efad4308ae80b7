import { readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { resolveInside } from './confine.ts';
import { readText } from './read-file.ts';

/** Folder of a project with its recorded sessions. */
export const SESSIONS_FOLDER = 'sessions';

/** Limit of `session.json`. Recordings have some hundred kilobytes of poses per minute. */
export const MAX_SESSION_BYTES = 64 * 2 ** 20;

/** A recorded session: a folder with `session.json`. */
export interface RecordedSession {
  /** Name of the folder. */
  readonly name: string;
  readonly title: string;
  readonly folder: string;
}

/**
 * The recorded sessions in the folders of `parent`, by name. Empty if `parent` is missing. Includes invalid ones, which report their
 * problem when played.
 */
export async function findSessions(parent: string): Promise<RecordedSession[]> {
  const entries = await readdir(parent, { withFileTypes: true }).catch(() => []);
  const names = entries.filter((entry) => entry.isDirectory() && !entry.name.startsWith('.')).map((entry) => entry.name);
  const found = await Promise.all(names.sort().map((name) => readSession(parent, name)));
  return found.filter((session) => session !== null);
}

async function readSession(parent: string, name: string): Promise<RecordedSession | null> {
  const text = await readText(await resolveInside(parent, `${name}/session.json`), MAX_SESSION_BYTES).catch(() => null);
  return text === null ? null : { name, title: titleOf(text) ?? name, folder: join(parent, name) };
}

function titleOf(text: string): string | null {
  try {
    const { title } = JSON.parse(text) as { title?: unknown };
    return typeof title === 'string' && title !== '' ? title : null;
  } catch {
    return null;
  }
}
