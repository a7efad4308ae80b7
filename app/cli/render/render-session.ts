import { join, resolve } from 'node:path';
import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { realFolder } from '../../services/confine.ts';
import type { Installation } from '../../services/installation.ts';
import { readText } from '../../services/read-file.ts';
import { ROOMS } from '../../services/rooms.ts';
import { findSessions, MAX_SESSION_BYTES } from '../../services/session-list.ts';
import type { RenderSession } from './frame-source.page.ts';
import type { SizePx } from './render-options.ts';

export interface FoundSession {
  readonly session: RenderSession;
  readonly sizePx: SizePx;
  /** Real paths of the session’s folders, by the first part of its URL. */
  readonly sessionFolders: Readonly<Record<string, string>>;
}

/** Default size in a room. */
const ROOM_SIZE: SizePx = { widthPx: 1280, heightPx: 720 };

const ROOM_PREFIX = 'room:';

/** Finds the session of `--session`, or the default one. SCR054 if it does not exist. */
export async function findRenderSession(
  named: string | null,
  projectRoot: string,
  installation: Installation,
  size: SizePx | null,
): Promise<Result<FoundSession>> {
  if (named?.startsWith(ROOM_PREFIX)) return findRoom(named.slice(ROOM_PREFIX.length), installation, size);
  const folder = named === null ? await defaultFolder(projectRoot, installation) : resolve(named);
  if (folder === null) return findRoom('studio', installation, size);
  const text = await readText(join(folder, 'session.json'), MAX_SESSION_BYTES).catch(() => null);
  if (text === null) {
    return broken(`${named ?? folder} is not a session: it has no session.json.`, 'Name a folder that holds one, or room:studio.');
  }
  return {
    output: {
      session: { kind: 'recorded', url: 'session/' },
      sizePx: size ?? sizeOf(text),
      sessionFolders: { session: await realFolder(folder) },
    },
    diagnostics: [],
  };
}

async function defaultFolder(projectRoot: string, { sessionsDir }: Installation): Promise<string | null> {
  const [own] = await findSessions(join(projectRoot, 'sessions'));
  if (own) return own.folder;
  const shipped = await findSessions(sessionsDir);
  return (shipped.find(({ name }) => name === 'studio') ?? shipped[0])?.folder ?? null;
}

function findRoom(name: string, { roomsDir }: Installation, size: SizePx | null): Result<FoundSession> {
  const room = ROOMS.find((candidate) => candidate.name === name);
  if (!room) return broken(`Unknown room ${JSON.stringify(name)}.`, `Name one of ${ROOMS.map((r) => r.name).join(', ')}.`);
  const sizePx = size ?? ROOM_SIZE;
  const captureUrl = room.capture === null ? null : `rooms/${room.capture}`;
  return {
    output: {
      session: { kind: 'room', captureUrl, sizePx: [sizePx.widthPx, sizePx.heightPx] },
      sizePx,
      sessionFolders: { rooms: roomsDir },
    },
    diagnostics: [],
  };
}

/** Size of the session’s frames. Invalid files are reported when the session is opened. */
function sizeOf(text: string): SizePx {
  try {
    const { color } = JSON.parse(text) as { color?: Partial<SizePx> };
    const { widthPx, heightPx } = color ?? {};
    if (Number.isInteger(widthPx) && Number.isInteger(heightPx)) return { widthPx: widthPx as number, heightPx: heightPx as number };
  } catch {
    // Reported when the session is opened.
  }
  return ROOM_SIZE;
}

function broken(message: string, fix: string): Result<never> {
  const diagnostic: Diagnostic = { code: 'SCR054', severity: 'error', message, fix };
  return { output: null, diagnostics: [diagnostic] };
}
