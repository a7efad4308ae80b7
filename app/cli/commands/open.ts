import { spawn } from 'node:child_process';
import { join } from 'node:path';
import process from 'node:process';
import { startServer } from '../../server/start-server.ts';
import { errorCode } from '../../services/file-errors.ts';
import { findProject } from '../../services/project-files.ts';
import { type Command, type Context, type Outcome, UsageError } from '../command.ts';
import { findElectron } from '../find-electron.ts';
import { openAddress } from '../open-address.ts';

/** Browsers keep what a person chose (theme, keys, recent projects) by address, so it is the same at every start, where it is free. */
const USUAL_PORT = 17_246;

/** An Electron that ends by itself this soon did not start: a library is missing, say. */
const STARTED_MS = 5_000;

export const openCommand: Command = {
  name: 'open',
  usage: '[PROJECT] [--browser] [--port N]',
  summary: 'Open the editor',
  doc: 'Opens the editor in a window of its own (Electron), with PROJECT where one is given. Where Electron cannot run, the same editor is served to the browser on this machine alone; the address printed is the key to it, and works until Scrim is stopped.',
  project: 'optional',
  options: {
    browser: { type: 'boolean', doc: 'In the browser, even where Electron is there.' },
    port: { type: 'string', value: 'N', doc: `The port for the browser; ${USUAL_PORT}, or a free one where that is taken, unless given.` },
  },
  examples: [
    { line: 'scrim open examples/first-light', says: 'Opens an example.' },
    {
      line: 'scrim open my-project --browser --port 8123',
      says: 'Serves the editor at a port that can be forwarded from another machine.',
    },
  ],
  run: async (call, context) => {
    const port = readPort(call.text('port'));
    const project = call.project === '' ? null : await findProject(call.project);
    const electron = call.flag('browser') ? null : await findElectron(context.installation.root, context.say);
    if (electron && 'path' in electron) {
      const started = await runElectron(electron.path, context, project);
      if (started || context.interrupted.aborted) return { status: 0, json: { ok: true, shell: 'electron' }, text: '', diagnostics: [] };
    }
    const why = electron === null ? null : 'path' in electron ? 'it ended as soon as it started' : electron.missing;
    return serve(context, project, port, why, call.flag('json'));
  },
};

/** Null where none was asked for. */
function readPort(text: string | null): number | null {
  if (text === null) return null;
  const port = Number(text);
  if (Number.isInteger(port) && port >= 0 && port <= 65_535) return port;
  throw new UsageError(`--port ${text} is no port: give a number from 1 to 65535.`);
}

/** Resolves when the window is closed; false where Electron could not start. */
function runElectron(path: string, { installation }: Context, project: string | null): Promise<boolean> {
  const { NODE_OPTIONS: _, ELECTRON_RUN_AS_NODE: __, ...env } = process.env;
  const args = [
    // Chromium refuses its sandbox to root, as in a container.
    ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
    join(installation.root, 'dist', 'electron', 'main.cjs'),
    ...(project === null ? [] : [`--open=${project}`]),
  ];
  const startMs = performance.now();
  return new Promise((resolve) => {
    const child = spawn(path, args, { stdio: ['ignore', 'ignore', 'inherit'], env });
    // Whoever ends Scrim ends its window; a terminal's Ctrl-C reaches both by itself.
    const end = () => child.kill();
    process.once('SIGTERM', end);
    child.on('error', () => resolve(false));
    child.on('close', (code) => {
      process.off('SIGTERM', end);
      resolve(code === 0 || performance.now() - startMs > STARTED_MS);
    });
  });
}

async function serve(context: Context, project: string | null, port: number | null, why: string | null, json: boolean): Promise<Outcome> {
  const { installation, print } = context;
  const log = (message: string) => console.error(message);
  const listenAt = (wanted: number) =>
    startServer({ installation, startPath: project, port: wanted, log }).catch((error: unknown) => {
      if (errorCode(error) === 'EADDRINUSE' || errorCode(error) === 'EACCES') return null;
      throw error;
    });
  const server = port === null ? ((await listenAt(USUAL_PORT)) ?? (await listenAt(0))) : await listenAt(port);
  if (server === null) throw new UsageError(`Port ${port} is taken or forbidden: give another one, or none.`);
  if (json) print(JSON.stringify({ ok: true, shell: 'server', url: server.url }));
  else {
    if (why !== null) print(`Electron cannot run here (${why}): the editor opens in the browser instead.`);
    print(`${server.url}\nCtrl-C stops it.`);
    openAddress(server.url);
  }
  await untilAborted(context.interrupted);
  await server.close();
  return { status: 0, json: undefined, text: '', diagnostics: [] };
}

function untilAborted(signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    if (signal.aborted) resolve();
    else signal.addEventListener('abort', () => resolve(), { once: true });
  });
}
