import { spawn } from 'node:child_process';
import { join } from 'node:path';
import process from 'node:process';
import { type Diagnostic, formatDiagnostic } from '../../../nodes/kit/diagnostics.ts';
import { type EditorServer, startServer } from '../../server/start-server.ts';
import { errorCode } from '../../services/file-errors.ts';
import { findProject } from '../../services/project-files.ts';
import { type Command, type Context, type Outcome, UsageError } from '../command.ts';
import { findElectron, hasDisplay } from '../find-electron.ts';

/** Command that opens an address, per platform. `start` is built into the Windows shell; its first argument is a window title. */
const OPENERS: Readonly<Partial<Record<NodeJS.Platform, readonly string[]>>> = {
  darwin: ['open'],
  win32: ['cmd', '/c', 'start', ''],
};

/** Default port. It is fixed, because browsers store preferences by origin. */
const USUAL_PORT = 17_246;

/** Time within which an exit of Electron means that it failed to start, for example because a library is missing. */
const STARTED_MS = 5_000;

export const openCommand: Command = {
  name: 'open',
  usage: '[PROJECT] [--browser] [--port N] [--preview-port N]',
  summary: 'Open the editor',
  doc: 'Opens the editor in its own window (Electron), with PROJECT if given. If Electron cannot run, serves the same editor to browsers on this machine only. Each address that is printed or opened works once; a new tab of the same browser needs no address. Opening an address a second time ends the session, because another person may have read it.',
  project: 'optional',
  options: {
    browser: { type: 'boolean', doc: 'Use the browser, even if Electron can run.' },
    port: { type: 'string', value: 'N', doc: `The port for the browser; by default ${USUAL_PORT}, or a free one if that is taken.` },
    'preview-port': {
      type: 'string',
      value: 'N',
      doc: 'The port for the preview, which has its own origin; by default the one after the editor’s.',
    },
  },
  examples: [
    { line: 'scrim open examples/first-light', says: 'Opens an example.' },
    {
      line: 'scrim open my-project --browser --port 8123',
      says: 'Serves the editor at port 8123 and its preview at 8124. Forward both to use them from another machine.',
    },
  ],
  run: async (call, context) => {
    const port = readPort('--port', call.text('port'));
    const previewPort = readPort('--preview-port', call.text('preview-port'));
    const project = call.project === '' ? null : await findProject(call.project);
    const electron = call.flag('browser') ? null : await findElectron(context.installation.root, context.say);
    if (electron && 'path' in electron) {
      const started = await runElectron(electron.path, context, project);
      if (started || context.interrupted.aborted) return { status: 0, json: { ok: true, shell: 'electron' }, text: '', diagnostics: [] };
    }
    const why = electron === null ? null : 'path' in electron ? 'it ended as soon as it started' : electron.missing;
    return serve(context, project, { port, previewPort }, why, call.flag('json'));
  },
};

/** Parses a port; null if the option is absent. */
function readPort(option: string, text: string | null): number | null {
  if (text === null) return null;
  const port = Number(text);
  if (text !== '' && Number.isInteger(port) && port >= 0 && port <= 65_535) return port;
  throw new UsageError(`${option} ${text} is not a port. Enter a number from 1 to 65535.`);
}

/** Opens the editor in Electron. Resolves to true when its window is closed; to false if Electron could not start. */
function runElectron(path: string, { installation }: Context, project: string | null): Promise<boolean> {
  const { NODE_OPTIONS: _, ELECTRON_RUN_AS_NODE: __, ...env } = process.env;
  const args = [
    // As root, such as in a container, Chromium does not start with its sandbox.
    ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
    join(installation.root, 'dist', 'electron', 'main.cjs'),
    ...(project === null ? [] : [`--open=${project}`]),
  ];
  const startMs = performance.now();
  return new Promise((resolve) => {
    const child = spawn(path, args, { stdio: ['ignore', 'ignore', 'inherit'], env });
    // SIGTERM reaches only this process, so it is passed on to the window. Ctrl-C in a terminal reaches both.
    const end = () => child.kill();
    process.once('SIGTERM', end);
    child.on('error', () => resolve(false));
    child.on('close', (code) => {
      process.off('SIGTERM', end);
      resolve(code === 0 || performance.now() - startMs > STARTED_MS);
    });
  });
}

async function serve(context: Context, project: string | null, ports: Ports, why: string | null, json: boolean): Promise<Outcome> {
  const { installation, print } = context;
  const log = (message: string) => console.error(message);
  const server = await listen(ports, (port, previewPort) => startServer({ installation, startPath: project, port, previewPort, log }));
  const url = server.invite();
  if (json) print(JSON.stringify({ ok: true, shell: 'server', url }));
  else {
    if (why !== null) print(`Electron cannot run here (${why}). The editor opens in the browser instead.`);
    print(`${url}\nThis address opens once. Ctrl-C stops Scrim.`);
    // Opens another address than the printed one, because all users of this machine can see the arguments of a process.
    openAddress(server.invite());
  }
  await untilAborted(AbortSignal.any([context.interrupted, server.ended]));
  await server.close();
  const done: Outcome = { status: 0, json: undefined, text: '', diagnostics: [] };
  if (!server.ended.aborted) return done;
  // With `--json` the JSON value has been printed, but a person may read the terminal.
  if (json) log(formatDiagnostic(OPENED_TWICE));
  return { ...done, status: 1, diagnostics: [OPENED_TWICE] };
}

const OPENED_TWICE: Diagnostic = {
  code: 'SCR075',
  severity: 'error',
  message: 'The address of this session was opened a second time, so the session has ended. Unsaved work is kept in the project.',
  fix: 'Start Scrim again. If you did not open the address twice, another person on this machine has read it.',
};

interface Ports {
  /** Port of the option; null if the option is absent. */
  readonly port: number | null;
  readonly previewPort: number | null;
}

/**
 * Listens on fixed ports for editor and preview, so that both can be forwarded. Without options, falls back to free ports if a
 * default port is taken.
 */
async function listen(
  { port, previewPort }: Ports,
  start: (port: number, previewPort: number) => Promise<EditorServer>,
): Promise<EditorServer> {
  const wanted = port ?? USUAL_PORT;
  const wantedPreview = previewPort ?? (wanted === 0 || wanted === 65_535 ? 0 : wanted + 1);
  if (wanted !== 0 && wantedPreview === wanted) throw new UsageError('--port and --preview-port are equal. Name two different ports.');
  try {
    return await start(wanted, wantedPreview);
  } catch (error) {
    if (errorCode(error) !== 'EADDRINUSE' && errorCode(error) !== 'EACCES') throw error;
    const { port: taken } = error as { port?: number };
    const isPreview = taken === wantedPreview;
    if (port === null && !(isPreview && previewPort !== null)) return listen({ port: 0, previewPort }, start);
    throw new UsageError(`Port ${taken} is taken or forbidden. Name another one with ${isPreview ? '--preview-port' : '--port'}.`);
  }
}

function untilAborted(signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    if (signal.aborted) resolve();
    else signal.addEventListener('abort', () => resolve(), { once: true });
  });
}

/** Opens an address in the default browser. Fails silently. */
function openAddress(url: string): void {
  if (!hasDisplay()) return;
  const [command, ...args] = OPENERS[process.platform] ?? ['xdg-open'];
  const child = spawn(command as string, [...args, url], { stdio: 'ignore', detached: true });
  child.on('error', () => {});
  child.unref();
}
