import { describe, expect, test } from '@jest/globals';
import { expectRefused, requestBytes, send, useAttackedServer } from './server-kit.ts';

const attacked = useAttackedServer();

/** Ways to write `..`, of servers that decode twice, decode too late, or know other separators. */
const UPS = [
  ...[
    '..',
    '%2e%2e',
    '.%2e',
    '%2E.',
    '%252e%252e',
    '%25252e%25252e',
    '%c0%ae%c0%ae',
    '%e0%80%ae%e0%80%ae',
    '%u002e%u002e',
    '..;',
    '..;a=b',
  ],
  ...['...', '....', '..%00', '..%20', '.. ', '..%09', '..%0d%0a', '\u2025', '%ef%bc%8e%ef%bc%8e', '..::$DATA'],
];
const SEPARATORS = ['/', '%2f', '%252f', '\\', '%5c', '%255c', '//', '/./', '%c0%af'];
const DEPTHS = [1, 3];

/** Paths below a project's address, each of which would be the secret if one rule failed. */
const NAMES = [
  ...['.scrim/secret.txt', '%2escrim/secret.txt', '.%73crim/secret.txt', './.scrim/secret.txt', 'assets/./../.scrim/secret.txt'],
  ...[
    'assets/',
    'assets',
    '',
    '.',
    '%2e',
    'assets/cup.glb%00.png',
    'assets/cup.glb/',
    'assets/cup.glb/..',
    'assets//cup.glb',
    '%',
    '%E0%A4%A',
  ],
  ...['assets/%2e%2e%2fsecret.txt', 'CON', 'assets/cup.glb::$DATA', 'C:/secret.txt', 'C:%5csecret.txt', '%5c%5c127.0.0.1%5cshare'],
];

/** Where the folders that are served begin, with the origin that serves them. */
async function starts(): Promise<readonly (readonly [origin: string, path: string])[]> {
  const { server, project } = attacked();
  const opened = (await server.host.dispatch('project.open', { path: project })) as { output: { assetBaseUrl: string } };
  const { pathname } = new URL(opened.output.assetBaseUrl);
  return [
    [server.previewOrigin, `${pathname}assets/`],
    [server.previewOrigin, '/'],
    [server.editorOrigin, '/assets/'],
  ];
}

async function expectNothingAt(origin: string, path: string): Promise<void> {
  const answer = await send(origin, requestBytes({ path, headers: [['host', new URL(origin).host]] }));
  expect({ path, isRefused: answer.status !== null && answer.status >= 400 && answer.status < 500 }).toEqual({ path, isRefused: true });
  expectRefused(answer, attacked().server.token);
}

describe('no address leads out of its folder', () => {
  test.each(UPS)('by %j, with every separator', async (up) => {
    for (const [origin, start] of await starts()) {
      for (const separator of SEPARATORS) {
        for (const depth of DEPTHS) await expectNothingAt(origin, `${start}${`${up}${separator}`.repeat(depth)}secret.txt`);
      }
    }
  });

  test.each(NAMES)('by the name %j', async (name) => {
    const [[origin, assets] = ['', '']] = await starts();
    await expectNothingAt(origin, `${assets.slice(0, -'assets/'.length)}${name}`);
  });

  test('as a whole path, or as a whole address of another server', async () => {
    const { server, base } = attacked();
    const { host } = new URL(server.editorOrigin);
    for (const path of [
      `${base}/secret.txt`,
      `//${base}/secret.txt`,
      `http://evil.example/`,
      `http://${host}/index.html`,
      '*',
      'index.html',
    ]) {
      await expectNothingAt(server.editorOrigin, path);
    }
  });
});

test('a project that is guessed is not there', async () => {
  const { server } = attacked();
  for (const key of ['0'.repeat(32), 'f'.repeat(32), '*', 'constructor', '__proto__', '']) {
    await expectNothingAt(server.previewOrigin, `/projects/${key}/assets/cup.glb`);
  }
});
