import { mkdir, mkdtemp, rm, symlink, writeFile } from 'node:fs/promises';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { createPageServers } from './page-servers.ts';

const servers = createPageServers();
let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-pages-'));
  for (const name of ['one', 'two']) {
    await mkdir(join(base, name, 'assets'), { recursive: true });
    await writeFile(join(base, name, 'index.html'), `page ${name}`);
  }
  await writeFile(join(base, 'one', 'assets', 'a b.js'), 'script');
  await writeFile(join(base, 'secret'), 'secret');
  await symlink(join(base, 'secret'), join(base, 'one', 'link'));
});
afterAll(async () => {
  await servers.dispose();
  await rm(base, { recursive: true, force: true });
});

/** The answer to a request with exactly this path, which `fetch` would normalize. */
function ask(url: string, path: string, headers = {}): Promise<readonly [status: number | undefined, text: string]> {
  return new Promise((resolve, reject) => {
    const asked = request(url, { path, headers }, (response) => {
      let text = '';
      response.on('data', (piece: Buffer) => {
        text += piece.toString();
      });
      response.on('end', () => resolve([response.statusCode, text]));
    });
    asked.on('error', reject);
    asked.end();
  });
}

test('a page is served on its own port, and keeps it', async () => {
  const one = await servers.serve(join(base, 'one'));
  const two = await servers.serve(join(base, 'two'));
  expect(two).not.toBe(one);
  expect(await servers.serve(join(base, 'one'))).toBe(one);
  expect(await ask(one, '/')).toEqual([200, 'page one']);
  expect(await ask(two, '/?visit')).toEqual([200, 'page two']);
  expect(await ask(one, '/assets/a%20b.js')).toEqual([200, 'script']);
  expect((await fetch(`${one}assets/a%20b.js`)).headers.get('content-type')).toBe('text/javascript; charset=utf-8');
});

test('nothing outside its folder is served, nor to another host name', async () => {
  const one = await servers.serve(join(base, 'one'));
  for (const path of ['/../secret', '/%2e%2e/secret', '/..%2fsecret', '/link', '/assets', '/none', '/%', '//secret']) {
    expect([path, ...(await ask(one, path))]).toEqual([path, 404, 'Not found.\n']);
  }
  expect((await ask(one, '/', { host: 'evil.example' }))[0]).toBe(403);
  expect((await fetch(one, { method: 'POST' })).status).toBe(404);
});

test('a folder without a page is refused', async () => {
  await expect(servers.serve(join(base, 'one', 'assets'))).rejects.toMatchObject({ diagnostic: { code: 'SCR004' } });
});
