import { randomBytes } from 'node:crypto';
import { createServer, type RequestListener, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { MAX_ASSET_BYTES } from '../contract/contract.ts';
import { createHost, type HostService } from '../services/host.ts';
import type { Installation } from '../services/installation.ts';
import { answerContent } from './answer-content.ts';
import { createApi } from './api.ts';
import { hostCheck } from './checks.ts';

export interface ServerOptions {
  readonly installation: Installation;
  readonly startPath: string | null;
  /** 0 takes a free one. The preview's is always free choice. */
  readonly port?: number;
  readonly maxMessageBytes?: number;
  readonly log: (message: string) => void;
}

export interface EditorServer {
  /** What to open: the token is behind `#`, which browsers keep to themselves. */
  readonly url: string;
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
 * The editor on loopback: two ports, because two origins are what keeps the preview from the host. Whoever wants the API needs
 * this launch's token, from the editor's own origin; both ports answer only to their own `Host`, which a page that rebinds its
 * domain to this address cannot fake.
 */
export async function startServer(options: ServerOptions): Promise<EditorServer> {
  const token = randomBytes(32).toString('hex');
  const editor = await listen(options.port ?? 0);
  const preview = await listen(0);
  const origins = { editor: originOf(editor.server), preview: originOf(preview.server) };
  const host = createHost({
    shell: { kind: 'server', origins, pickFolder: null, closeWindow: () => {}, showMenus: null },
    installation: options.installation,
    startPath: options.startPath,
    log: options.log,
  });
  const api = createApi({ host, token, origin: origins.editor, maxMessageBytes: options.maxMessageBytes ?? MAX_MESSAGE_BYTES });
  editor.answerWith(
    hostCheck(origins.editor, (request, response) => {
      if (request.url?.startsWith('/api/')) void api.answer(request, response);
      else void answerContent(host.content, 'editor', request, response);
    }),
  );
  preview.answerWith(hostCheck(origins.preview, (request, response) => void answerContent(host.content, 'preview', request, response)));
  return {
    url: `${origins.editor}/#token=${token}`,
    editorOrigin: origins.editor,
    previewOrigin: origins.preview,
    token,
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
