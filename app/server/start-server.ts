import { createServer, type IncomingMessage, type RequestListener, type Server, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { pipeline } from 'node:stream/promises';
import { MAX_ASSET_BYTES } from '../contract/call-parts.ts';
import type { Content } from '../services/content.ts';
import type { Origins } from '../services/content-policy.ts';
import { createHost, type HostService } from '../services/host.ts';
import type { Installation } from '../services/installation.ts';
import { hostCheck } from '../services/request-checks.ts';
import { createSession } from './access-session.ts';
import { createApi } from './api.ts';

export interface ServerOptions {
  readonly installation: Installation;
  readonly startPath: string | null;
  /** Port of the editor. If 0 or absent, the system chooses a free port. */
  readonly port?: number;
  /** Port of the preview. If 0 or absent, the system chooses a free port. */
  readonly previewPort?: number;
  readonly maxMessageBytes?: number;
  readonly log: (message: string) => void;
}

export interface EditorServer {
  /**
   * Creates an address that can be opened once. It contains a code in its fragment, which browsers do not send and the page exchanges
   * for the token. A second use ends the session, because other users can see the arguments with which browsers are started.
   */
  invite(): string;
  /** Aborts when an address was opened twice. The token is invalid from then on. */
  readonly ended: AbortSignal;
  readonly editorOrigin: string;
  readonly previewOrigin: string;
  readonly token: string;
  readonly host: HostService;
  close(): Promise<void>;
}

/** The largest asset plus the rest of its message. */
const MAX_MESSAGE_BYTES = MAX_ASSET_BYTES + 2 ** 20;

const LOOPBACK = '127.0.0.1';

/**
 * Serves the editor on two loopback ports: the preview has its own origin, so that it cannot access the host. API requests need the
 * token of this launch and the editor’s origin. Both ports check the `Host` header, against DNS rebinding.
 */
export async function startServer(options: ServerOptions): Promise<EditorServer> {
  const session = createSession();
  const editor = await listen(options.port ?? 0);
  const preview = await listen(options.previewPort ?? 0).catch(async (error: unknown) => {
    await shut(editor.server);
    throw error;
  });
  const origins = { editor: originOf(editor.server), preview: originOf(preview.server) };
  const host = createHost({
    shell: { kind: 'server', origins, pickFolder: null, closeWindow: () => {}, revealFile: null, openInBrowser: null, showMenus: null },
    installation: options.installation,
    startPath: options.startPath,
    log: options.log,
  });
  const api = createApi({ host, session, origin: origins.editor, maxMessageBytes: options.maxMessageBytes ?? MAX_MESSAGE_BYTES });
  editor.answerWith(
    hostCheck(origins.editor, (request, response) => {
      if (request.url?.startsWith('/api/')) void api.answer(request, response);
      else void answerContent(host.content, 'editor', request, response);
    }),
  );
  preview.answerWith(hostCheck(origins.preview, (request, response) => void answerContent(host.content, 'preview', request, response)));
  return {
    invite: () => `${origins.editor}/#code=${session.invite()}`,
    ended: session.ended,
    editorOrigin: origins.editor,
    previewOrigin: origins.preview,
    token: session.token,
    host,
    close: async () => {
      api.dispose();
      await Promise.all([shut(editor.server), shut(preview.server)]);
      await host.dispose();
    },
  };
}

/** Listens first and sets the handler later, because the handlers depend on both ports. */
async function listen(port: number): Promise<{ server: Server; answerWith: (listener: RequestListener) => void }> {
  const server = createServer();
  await new Promise<void>((resolve, reject) => {
    server.once('error', reject);
    server.listen(port, LOOPBACK, resolve);
  });
  return { server, answerWith: (listener) => server.on('request', listener) };
}

function originOf(server: Server): string {
  return `http://${LOOPBACK}:${(server.address() as AddressInfo).port}`;
}

function shut(server: Server): Promise<void> {
  return new Promise((resolve) => {
    server.close(() => resolve());
    server.closeAllConnections();
  });
}

async function answerContent(content: Content, origin: keyof Origins, request: IncomingMessage, response: ServerResponse): Promise<void> {
  const { status, headers, body } = await content.answer(origin, request.method ?? 'GET', request.url ?? '/');
  response.writeHead(status, headers);
  // A client that disconnects early is not an error.
  await pipeline(body, response).catch(() => {});
}
