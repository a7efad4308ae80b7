import { mkdir, mkdtemp, readFile, rm, symlink, truncate, writeFile } from 'node:fs/promises';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { type HostEvent, MAX_COPIED_BYTES } from '../contract/contract.ts';
import { createHttpHost, TOKEN_HEADER } from '../contract/http-client.ts';
import { encodeMessage, MESSAGE_TYPE } from '../contract/message.ts';
import { installationAt } from '../services/installation.ts';
import { type EditorServer, startServer } from './start-server.ts';

const MAX_MESSAGE_BYTES = 1 << 20;

let base = '';
let project = '';
let server: EditorServer;
const faults: string[] = [];

beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-server-'));
  project = join(base, 'first');
  await mkdir(join(project, 'assets'), { recursive: true });
  await mkdir(join(project, 'shaders'));
  await writeFile(join(project, 'project.scrim.json'), '{"title":"First"}\n');
  await writeFile(join(project, 'shaders', 'edge.fs'), 'void main() {}\n');
  await writeFile(join(project, 'assets', 'cup.glb'), 'glTF');
  for (const page of ['editor', 'preview']) {
    await mkdir(join(base, 'install', 'dist', page, 'assets'), { recursive: true });
    await writeFile(join(base, 'install', 'dist', page, 'index.html'), `<title>${page}</title>`);
    await writeFile(join(base, 'install', 'dist', page, 'assets', `${page}.js`), '1');
  }
  await mkdir(join(base, 'install', 'examples', 'sessions', 'studio'), { recursive: true });
  await writeFile(join(base, 'install', 'examples', 'sessions', 'studio', 'session.json'), '{"title":"Studio"}');
  await symlink(resolve(import.meta.dirname, '../../node_modules'), join(base, 'install', 'node_modules'));
  faults.length = 0;
  server = await startServer({
    installation: installationAt(join(base, 'install'), '1.2.3'),
    startPath: project,
    maxMessageBytes: MAX_MESSAGE_BYTES,
    log: (message) => faults.push(message),
  });
});
afterEach(async () => {
  await server.close();
  await rm(base, { recursive: true, force: true });
  expect(faults).toEqual([]);
});

let tabs = 0;

/** Another tab each time. */
function connect(token = server.token) {
  return createHttpHost({
    origin: server.editorOrigin,
    token,
    client: `tab${tabs++}`,
    fetch: withOrigin,
    waitMs: () => Promise.resolve(),
  });
}

/** Node sends no `Origin`; a browser does. */
function withOrigin(input: string | URL | Request, init?: RequestInit): Promise<Response> {
  return fetch(input, { ...init, headers: { ...init?.headers, origin: server.editorOrigin } });
}

interface RawAnswer {
  readonly status: number;
  readonly text: string;
  readonly headers: NodeJS.Dict<string | string[]>;
}

/** A request with exactly these headers and this path: no library mends them. */
function raw(url: string, path: string, options: { method?: string; headers?: Record<string, string>; body?: Uint8Array } = {}) {
  return new Promise<RawAnswer>((resolve, reject) => {
    const { hostname, port } = new URL(url);
    const outgoing = request({ hostname, port, path, method: options.method ?? 'GET', headers: options.headers ?? {} }, (response) => {
      let text = '';
      response.setEncoding('utf8');
      response.on('data', (chunk) => {
        text += chunk;
      });
      response.on('end', () => resolve({ status: response.statusCode ?? 0, text, headers: response.headers }));
    });
    outgoing.on('error', reject);
    outgoing.end(options.body);
  });
}

function rawCall(headers: Record<string, string>, method = 'app.info') {
  return raw(server.editorOrigin, `/api/call/${method}`, {
    method: 'POST',
    headers: { 'content-type': MESSAGE_TYPE, origin: server.editorOrigin, [TOKEN_HEADER]: server.token, ...headers },
    body: encodeMessage({}),
  });
}

describe('who may call', () => {
  test('the editor’s page with the token', async () => {
    expect(await rawCall({})).toMatchObject({ status: 200 });
  });

  test.each([
    ['a wrong token', { [TOKEN_HEADER]: '0'.repeat(64) }, 403],
    ['an empty token', { [TOKEN_HEADER]: '' }, 403],
    ['another origin', { origin: 'https://evil.example' }, 403],
    ['an opaque origin', { origin: 'null' }, 403],
    ['a rebound name', { host: 'evil.example' }, 403],
    ['this address by another name', { host: 'localhost' }, 403],
    ['a form’s message type', { 'content-type': 'text/plain' }, 415],
  ])('not %s', async (_name, headers, status) => {
    const answer = await rawCall(headers as Record<string, string>);
    expect(answer.status).toBe(status);
    expect(answer.text).not.toContain('1.2.3');
  });

  test('not the preview’s page, even with the token', async () => {
    expect(await rawCall({ origin: server.previewOrigin })).toMatchObject({ status: 403 });
    const there = await raw(server.previewOrigin, '/api/call/app.info', { method: 'POST', headers: { [TOKEN_HEADER]: server.token } });
    expect(there.status).toBe(405);
  });

  test('nobody without the headers', async () => {
    expect(await raw(server.editorOrigin, '/api/call/app.info', { method: 'POST' })).toMatchObject({ status: 403 });
    expect(await raw(server.editorOrigin, '/api/events')).toMatchObject({ status: 403 });
  });

  test('the server listens on loopback alone', () => {
    expect(new URL(server.invite()).hostname).toBe('127.0.0.1');
  });
});

describe('what may be called', () => {
  test.each(['nothing.here', 'constructor', '__proto__', 'app.info/x', ''])('not %j', async (method) => {
    const answer = await rawCall({}, method);
    expect(answer.status).toBeGreaterThanOrEqual(400);
    expect(JSON.parse(answer.text).diagnostic.code).toBe('SCR073');
  });

  test('nothing with an input that the contract does not know', async () => {
    const host = connect();
    await expect(host.call('project.open', { path: 7 } as never)).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    await expect(host.call('project.close', { handle: '../../etc' })).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
    await expect(host.call('project.close', { handle: 'a'.repeat(32) })).rejects.toMatchObject({ diagnostic: { code: 'SCR073' } });
  });

  test('nothing too large, whether its header says so or not', async () => {
    const host = connect();
    const { handle } = await host.call('project.open', { path: project });
    const bytes = new Uint8Array(MAX_MESSAGE_BYTES + 1);
    await expect(host.call('asset.import', { handle, name: 'big.png', bytes })).rejects.toMatchObject({ diagnostic: { code: 'SCR005' } });
    const chunked = await raw(server.editorOrigin, '/api/call/asset.import', {
      method: 'POST',
      headers: { 'content-type': MESSAGE_TYPE, origin: server.editorOrigin, [TOKEN_HEADER]: server.token, 'transfer-encoding': 'chunked' },
      body: bytes,
    });
    expect(chunked.status).toBe(413);
    expect(await host.call('app.info', {})).toMatchObject({ version: '1.2.3', startPath: project });
  });

  test('nothing damaged', async () => {
    const message = encodeMessage({ path: project });
    for (const body of [message.subarray(0, 3), message.subarray(0, message.length - 1), new Uint8Array(40).fill(255)]) {
      const headers = { 'content-type': MESSAGE_TYPE, origin: server.editorOrigin, [TOKEN_HEADER]: server.token };
      expect(await raw(server.editorOrigin, '/api/call/project.open', { method: 'POST', headers, body })).toMatchObject({ status: 400 });
    }
  });
});

describe('projects', () => {
  test('open, change, save and open again', async () => {
    const host = connect();
    const opened = await host.call('project.open', { path: join(project, 'project.scrim.json') });
    expect(opened.files).toEqual({ project: '{"title":"First"}\n', layout: null, sources: { 'edge.fs': 'void main() {}\n' } });
    expect(opened.assetFiles).toEqual([{ path: 'assets/cup.glb', bytes: 4 }]);
    const files = { project: '{"title":"Second"}\n', layout: '{}\n', sources: { 'blur.fs': 'void main() { }\n' } };
    const { revision } = await host.call('project.save', { handle: opened.handle, files, revision: opened.revision, overwrite: false });
    const again = await host.call('project.open', { path: project });
    expect(again.files).toEqual(files);
    expect(again.revision).toBe(revision);
  });

  test('a save does not run over somebody else’s change, unless told to', async () => {
    const host = connect();
    const { handle, files, revision } = await host.call('project.open', { path: project });
    await writeFile(join(project, 'project.scrim.json'), '{"title":"Theirs"}\n');
    const mine = { ...files, project: '{"title":"Mine"}\n' };
    await expect(host.call('project.save', { handle, files: mine, revision, overwrite: false })).rejects.toMatchObject({
      diagnostic: { code: 'SCR063' },
    });
    expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe('{"title":"Theirs"}\n');
    await host.call('project.save', { handle, files: mine, revision, overwrite: true });
    expect(await readFile(join(project, 'project.scrim.json'), 'utf8')).toBe('{"title":"Mine"}\n');
  });

  test('shader names that lead elsewhere are refused, and nothing is written', async () => {
    const host = connect();
    const { handle, files, revision } = await host.call('project.open', { path: project });
    for (const name of ['../evil.fs', '..\\evil.fs', '/tmp/evil.fs', '.hidden.fs', 'x.js', 'a/b.fs', 'a\0.fs']) {
      const bad = { project: '{}', layout: null, sources: { [name]: '' } };
      await expect(host.call('project.save', { handle, files: bad, revision, overwrite: true })).rejects.toMatchObject({
        diagnostic: { code: 'SCR031' },
      });
    }
    expect((await host.call('project.open', { path: project })).files).toEqual(files);
  });

  test('unsaved work is found again after a crash, and forgotten by a save', async () => {
    const host = connect();
    const { handle, files, revision } = await host.call('project.open', { path: project });
    const work = { ...files, project: '{"title":"Unsaved"}\n' };
    await host.call('project.autosave', { handle, files: work });
    const after = await host.call('project.open', { path: project });
    expect(after.recovery).toEqual(work);
    expect(after.files).toEqual(files);
    await host.call('project.save', { handle, files: work, revision, overwrite: false });
    expect((await host.call('project.open', { path: project })).recovery).toBeNull();
  });

  test('a copy has the assets, and never lands on other files', async () => {
    const host = connect();
    const { handle, files } = await host.call('project.open', { path: project });
    const copy = await host.call('project.save-as', { handle, path: join(base, 'copy'), files });
    expect(copy.files).toEqual(files);
    expect(await readFile(join(base, 'copy', 'assets', 'cup.glb'), 'utf8')).toBe('glTF');
    await expect(host.call('project.save-as', { handle, path: join(base, 'copy'), files })).rejects.toMatchObject({
      diagnostic: { code: 'SCR061' },
    });
  });

  test.each([
    ['a folder that is none', 'nowhere', 'SCR004'],
    ['a folder without a project', 'install', 'SCR004'],
  ])('%s is refused', async (_name, path, code) => {
    await expect(connect().call('project.open', { path: join(base, path) })).rejects.toMatchObject({ diagnostic: { code } });
  });

  test('a document of 200 MB is refused before it is read', async () => {
    const huge = join(base, 'huge');
    await mkdir(huge);
    await writeFile(join(huge, 'project.scrim.json'), '{}');
    await truncate(join(huge, 'project.scrim.json'), 200 * 2 ** 20);
    await expect(connect().call('project.open', { path: huge })).rejects.toMatchObject({ diagnostic: { code: 'SCR005' } });
  });

  test('a change from outside is told, our own save is not', async () => {
    const host = connect();
    const events: HostEvent[] = [];
    const told = new Promise<void>((resolve) => {
      const stop = host.subscribe((event) => {
        events.push(event);
        stop();
        resolve();
      });
    });
    const { handle, files, revision } = await host.call('project.open', { path: project });
    const mine = { ...files, layout: '{}\n' };
    await host.call('project.save', { handle, files: mine, revision, overwrite: false });
    await writeFile(join(project, 'shaders', 'edge.fs'), 'void main() { discard; }\n');
    await told;
    const now = await host.call('project.open', { path: project });
    expect(events).toMatchObject([{ kind: 'shaders-changed-outside', handle, revision: now.revision }]);
  });
});

describe('assets', () => {
  test.each([
    ['a plain name', 'teapot.glb', 'assets/teapot.glb'],
    ['a taken name', 'cup.glb', 'assets/cup-2.glb'],
    ['a path', '../../etc/passwd', 'assets/passwd'],
    ['a Windows path', 'C:\\Users\\me\\Tea Pot (1).GLB', 'assets/Tea-Pot-1.glb'],
    ['letters of all sorts', 'Überraschung № 1.png', 'assets/Uberraschung-No-1.png'],
    ['a device', 'con.png', 'assets/asset-con.png'],
    ['a hidden file', '.htaccess', 'assets/htaccess'],
    ['nothing left', '***.png', 'assets/asset.png'],
  ])('are imported under a free and harmless name: %s', async (_name, name, path) => {
    const host = connect();
    const { handle } = await host.call('project.open', { path: project });
    const bytes = new Uint8Array([0, 1, 254, 255]);
    expect(await host.call('asset.import', { handle, name, bytes })).toEqual({ path });
    expect(new Uint8Array(await readFile(join(project, path)))).toEqual(bytes);
    expect(await host.call('asset.import', { handle, name, bytes })).toEqual({ path });
  });

  test('are read for copying, and nothing else of the project or the disk is', async () => {
    const host = connect();
    const { handle } = await host.call('project.open', { path: project });
    expect(await host.call('asset.read', { handle, path: 'assets/cup.glb' })).toEqual({ base64: Buffer.from('glTF').toString('base64') });
    for (const path of ['project.scrim.json', 'assets/../project.scrim.json', '/etc/passwd', 'assets/..\\x']) {
      await expect(host.call('asset.read', { handle, path })).rejects.toMatchObject({ diagnostic: { code: 'SCR031' } });
    }
    await expect(host.call('asset.read', { handle, path: 'assets/none.glb' })).rejects.toMatchObject({ diagnostic: {} });
    await writeFile(join(project, 'assets', 'big.glb'), Buffer.alloc(MAX_COPIED_BYTES + 1));
    await expect(host.call('asset.read', { handle, path: 'assets/big.glb' })).rejects.toMatchObject({ diagnostic: { code: 'SCR005' } });
  });

  test('are never written through a link', async () => {
    await rm(join(project, 'assets'), { recursive: true });
    await mkdir(join(base, 'elsewhere'));
    await symlink(join(base, 'elsewhere'), join(project, 'assets'));
    const host = connect();
    const { handle } = await host.call('project.open', { path: project });
    const call = host.call('asset.import', { handle, name: 'x.png', bytes: new Uint8Array(1) });
    await expect(call).rejects.toMatchObject({ diagnostic: { code: 'SCR031' } });
  });
});

describe('the two origins', () => {
  test('each serves its own page, under its own policy', async () => {
    const editor = await raw(server.editorOrigin, '/');
    expect(editor.text).toBe('<title>editor</title>');
    expect(editor.headers['content-security-policy']).toContain("default-src 'none'");
    expect(editor.headers['content-security-policy']).toContain(`frame-src ${server.previewOrigin};`);
    expect(editor.headers['content-security-policy']).toContain("frame-ancestors 'none'");
    expect(editor.headers['origin-agent-cluster']).toBe('?1');
    const preview = await raw(server.previewOrigin, '/index.html');
    expect(preview.text).toBe('<title>preview</title>');
    expect(preview.headers['content-security-policy']).toContain(`frame-ancestors ${server.editorOrigin}`);
    expect(preview.headers['origin-agent-cluster']).toBe('?1');
    expect(await raw(server.editorOrigin, '/assets/editor.js')).toMatchObject({ status: 200 });
    expect(await raw(server.editorOrigin, '/assets/preview.js')).toMatchObject({ status: 404 });
    expect(await raw(server.previewOrigin, '/assets/preview.js')).toMatchObject({ status: 200 });
    expect(await raw(server.previewOrigin, '/assets/editor.js')).toMatchObject({ status: 404 });
    expect(await raw(server.editorOrigin, '/../preview/index.html')).toMatchObject({ status: 404 });
    expect(await raw(server.previewOrigin, '/', { headers: { host: 'evil.example' } })).toMatchObject({ status: 403 });
  });

  test('a project’s files are under an address that cannot be guessed, and only there, and are data', async () => {
    const host = connect();
    const { handle, assetBaseUrl } = await host.call('project.open', { path: project });
    await writeFile(join(project, 'assets', 'evil.html'), '<script>1</script>');
    const { pathname } = new URL(assetBaseUrl);
    expect(pathname).toMatch(/^\/projects\/[0-9a-f]{32}\/$/);
    expect(pathname).not.toContain(handle);
    const cup = await raw(server.previewOrigin, `${pathname}assets/cup.glb`);
    expect(cup).toMatchObject({ status: 200, text: 'glTF' });
    expect(cup.headers['content-type']).toBe('model/gltf-binary');
    const page = await raw(server.previewOrigin, `${pathname}assets/evil.html`);
    expect(page.headers['content-type']).toBe('application/octet-stream');
    expect(page.headers['content-security-policy']).toContain('sandbox');
    expect(await raw(server.editorOrigin, `${pathname}assets/cup.glb`)).toMatchObject({ status: 404 });
    await host.call('project.close', { handle });
    expect(await raw(server.previewOrigin, `${pathname}assets/cup.glb`)).toMatchObject({ status: 404 });
  });

  test('nothing outside a project can be read by its address', async () => {
    const host = connect();
    const { assetBaseUrl, handle, files } = await host.call('project.open', { path: project });
    await host.call('project.autosave', { handle, files });
    await writeFile(join(base, 'secret.txt'), 'secret');
    await symlink(join(base, 'secret.txt'), join(project, 'assets', 'link.txt'));
    const { pathname } = new URL(assetBaseUrl);
    const tries = [
      '../secret.txt',
      'assets/../../secret.txt',
      '%2e%2e/secret.txt',
      '..%2fsecret.txt',
      '%252e%252e/secret.txt',
      '..%5csecret.txt',
      '..\\secret.txt',
      'assets/link.txt',
      'assets/cup.glb%00.png',
      '%E0%A4%A',
      '.scrim/.gitignore',
      '%2escrim/.gitignore',
      'assets/',
      '',
      `${base}/secret.txt`,
    ];
    for (const path of tries) {
      const answer = await raw(server.previewOrigin, `${pathname}${path}`);
      expect([path, answer.status]).toEqual([path, 404]);
    }
  });

  test('recorded sessions and rooms are listed, with addresses that work', async () => {
    await mkdir(join(project, 'sessions', 'my desk'), { recursive: true });
    await writeFile(join(project, 'sessions', 'my desk', 'session.json'), '{"title":"My desk"}');
    const host = connect();
    const { handle } = await host.call('project.open', { path: project });
    const list = await host.call('session.list', { handle });
    expect(list.map(({ id, title, kind }) => `${kind} ${id} ${title}`)).toEqual([
      'recorded project/my desk My desk',
      'recorded example/studio Studio',
      'room room/studio Studio',
      'room room/living_room Living room',
      'room room/meeting_room Meeting room',
      'room room/music_room Music room',
      'room room/office_large Large office',
      'room room/office_small Small office',
    ]);
    const urls = list.flatMap(({ kind, url }) => (url === null ? [] : [kind === 'room' ? url : `${url}session.json`]));
    expect(urls).toHaveLength(7);
    for (const url of urls) expect([url, (await raw(server.previewOrigin, new URL(url).pathname)).status]).toEqual([url, 200]);
  });
});
