import { createServer, type RequestListener, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { MAX_ASSET_BYTES } from '../contract/contract.ts';
import { createHost, type HostService } from '../services/host.ts';
import type { Installation } from '../services/installation.ts';
import { createSession } from './access-session.ts';
import { answerContent } from './answer-content.ts';
import { createApi } from './api.ts';
import { hostCheck } from './request-checks.ts';

export interface ServerOptions {
  readonly installation: Installation;
  readonly startPath: string | null;
  /** 0 takes a free one. */
  readonly port?: number;
  /** The preview's; 0 takes a free one, and so does none. */
  readonly previewPort?: number;
  readonly maxMessageBytes?: number;
  readonly log: (message: string) => void;
}

export interface EditorServer {
  /**
   * A new address to open, once: its code is behind `#`, which browsers keep to themselves, and is exchanged for the token. Opened
   * again it ends the session, because the list of processes shows other people which addresses browsers are started with.
   */
  invite(): string;
  /** Aborts when an address was opened again: the token is worth nothing any more. */
  readonly ended: AbortSignal;
  readonly editorOrigin: string;
  readonly previewOrigin: string;
  readonly token: string;
  readonly host: HostService;
  close(): Promise<void>;
}

/** The largest asset, and room for what stands around it. */
const MAX_MESSAGE_BYTES = MAX_ASSET_BYTES + 2 ** 20;

const LOOPBACK = '127.0.0.1';

/**
 * Serves the editor on loopback, on two ports: the preview has an origin of its own, so that it cannot reach the host. A request to
 * the API needs the token of this launch and comes from the editor's origin. Both ports answer only to their own `Host`, which a
 * page that rebinds its domain to this address cannot fake.
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
    shell: { kind: 'server', origins, pickFolder: null, closeWindow: () => {}, showMenus: null },
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
      host.dispose();
      await Promise.all([shut(editor.server), shut(preview.server)]);
    },
  };
}

/** Listens before there is anything to answer with, because the answers depend on both ports. */
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
