import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, afterEach, beforeAll, expect } from '@jest/globals';
import { TOKEN_HEADER } from '../../app/contract/http-client.ts';
import { encodeMessage, MESSAGE_TYPE } from '../../app/contract/message.ts';
import { type EditorServer, startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';

/** The content of files that no request may read. */
export const SECRET = 'the-secret-of-this-test';
/** What only the API tells. */
export const VERSION = '9.8.7-of-this-test';
export const MAX_MESSAGE_BYTES = 1 << 20;
/** An answer ends normally; only a server that hangs is cut off. */
const HANGS_MS = 20_000;

export interface AttackedServer {
  readonly server: EditorServer;
  /** The folder that holds the project and the secret. */
  readonly base: string;
  readonly project: string;
  /** What the server said of faults of its own. */
  readonly faults: readonly string[];
}

/** A server for the suite, of a folder with a secret beside the project. After each test it still answers, and made no mistake. */
export function useAttackedServer(): () => AttackedServer {
  let attacked: AttackedServer;
  beforeAll(async () => {
    const base = await mkdtemp(join(tmpdir(), 'scrim-hostile-'));
    const project = join(base, 'project');
    const faults: string[] = [];
    for (const [path, text] of [
      ['secret.txt', SECRET],
      ['project/project.scrim.json', `{"title":"${SECRET}"}`],
      ['project/.scrim/secret.txt', SECRET],
      ['project/assets/cup.glb', 'glTF'],
      ['install/secret.txt', SECRET],
      ['install/dist/editor/index.html', '<title>editor</title>'],
      ['install/dist/preview/index.html', '<title>preview</title>'],
    ]) {
      await mkdir(join(base, path as string, '..'), { recursive: true });
      await writeFile(join(base, path as string), text as string);
    }
    const installation = installationAt(join(base, 'install'), VERSION);
    const log = (message: string) => faults.push(message);
    const server = await startServer({ installation, startPath: project, maxMessageBytes: MAX_MESSAGE_BYTES, log });
    attacked = { server, base, project, faults };
  });
  afterEach(async () => {
    expect((await callRaw(attacked.server, {})).status).toBe(200);
    expect(attacked.faults).toEqual([]);
  });
  afterAll(async () => {
    await attacked.server.close();
    await rm(attacked.base, { recursive: true, force: true });
  });
  return () => attacked;
}

export interface RawAnswer {
  /** Null where the server closed the connection without a word. */
  readonly status: number | null;
  /** All that it sent, heads included. */
  readonly text: string;
}

/** Sends exactly these bytes to an address on loopback, and reads until the server closes. */
export function send(origin: string, bytes: string | Uint8Array): Promise<RawAnswer> {
  const { hostname, port } = new URL(origin);
  return new Promise((resolve, reject) => {
    let text = '';
    const socket = connect({ host: hostname, port: Number(port) }, () => socket.write(bytes));
    const finish = () => {
      const status = /^HTTP\/1\.1 (\d{3})/.exec(text)?.[1];
      resolve({ status: status === undefined ? null : Number(status), text });
    };
    socket.setTimeout(HANGS_MS, () => {
      socket.destroy();
      reject(
        new Error(`The server neither answered to the end nor closed within ${HANGS_MS} ms of silence; it sent ${text.slice(0, 500)}`),
      );
    });
    socket.setEncoding('latin1');
    socket.on('data', (chunk) => {
      text += chunk;
    });
    // A server may close while it is still being written to.
    socket.on('error', finish);
    socket.on('close', finish);
  });
}

export interface RawRequest {
  readonly method?: string;
  readonly path?: string;
  /** In order; names may repeat. */
  readonly headers?: readonly (readonly [string, string])[];
  readonly body?: string | Uint8Array;
}

/** The text of a request that ends its connection; no library mends it. */
export function requestBytes({ method = 'GET', path = '/', headers = [], body = '' }: RawRequest): Uint8Array {
  const lines = [`${method} ${path} HTTP/1.1`, ...headers.map(([name, value]) => `${name}: ${value}`), 'connection: close', '', ''];
  return Buffer.concat([Buffer.from(lines.join('\r\n'), 'latin1'), typeof body === 'string' ? Buffer.from(body) : body]);
}

/** Headers of a call as the editor's page makes it. A null takes one away; more are added in `more`. */
export function callHeaders(
  server: EditorServer,
  changes: Readonly<Record<string, string | null>> = {},
  more: readonly (readonly [string, string])[] = [],
): (readonly [string, string])[] {
  const all: Record<string, string | null> = {
    host: new URL(server.editorOrigin).host,
    origin: server.editorOrigin,
    'content-type': MESSAGE_TYPE,
    [TOKEN_HEADER]: server.token,
    'content-length': String(encodeMessage({}).length),
    ...changes,
  };
  return [...Object.entries(all).flatMap(([name, value]) => (value === null ? [] : [[name, value] as const])), ...more];
}

/** `app.info`, which tells the version, with headers that differ from an honest page's. */
export function callRaw(
  server: EditorServer,
  changes: Readonly<Record<string, string | null>>,
  more: readonly (readonly [string, string])[] = [],
  request: RawRequest = {},
): Promise<RawAnswer> {
  const bytes = requestBytes({
    method: 'POST',
    path: '/api/call/app.info',
    headers: callHeaders(server, changes, more),
    body: encodeMessage({}),
    ...request,
  });
  return send(server.editorOrigin, bytes);
}

/** Refused: an answer that says so, or none; in either case without private data. */
export function expectRefused({ status, text }: RawAnswer, token: string): void {
  if (status !== null) expect(status).toBeGreaterThanOrEqual(400);
  expect(status).not.toBe(500);
  for (const secret of [SECRET, VERSION, token]) expect(text).not.toContain(secret);
}
