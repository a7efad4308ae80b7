import { describe, expect, test } from '@jest/globals';
import { CODE_HEADER, SESSION_PATH, TOKEN_HEADER } from '../../app/contract/http-client.ts';
import { callRaw, expectRefused, requestBytes, send, useAttackedServer } from './server-kit.ts';

const attacked = useAttackedServer();

type Changes = Readonly<Record<string, string | null>>;

async function expectCallRefused(changes: Changes, more: readonly (readonly [string, string])[] = []): Promise<void> {
  const { server } = attacked();
  expectRefused(await callRaw(server, changes, more), server.token);
}

/** `@` is the port. */
const WRONG_HOSTS = [
  ...['evil.example', 'evil.example:@', 'localhost:@', 'LOCALHOST:@', '127.0.0.1', '127.0.0.1:', '127.0.0.1:0', '127.0.0.1:80', '127.1:@'],
  ...['0.0.0.0:@', '[::1]:@', '2130706433:@', '0x7f.0.0.1:@', '127.0.0.1.nip.io:@', '127.0.0.1:@.evil.example', 'evil@127.0.0.1:@'],
  ...['127.0.0.1:@/', '127.0.0.1:@, evil.example', 'evil.example, 127.0.0.1:@', ' ', '127.0.0.1:0@', 'http://127.0.0.1:@'],
];

describe('by another name, as after DNS rebinding', () => {
  test.each(WRONG_HOSTS)('Host %j gets nothing, from either port', async (text) => {
    const { server } = attacked();
    await expectCallRefused({ host: text.replace('@', new URL(server.editorOrigin).port) });
    for (const origin of [server.editorOrigin, server.previewOrigin]) {
      const host = text.replace('@', new URL(origin).port);
      const answer = await send(origin, requestBytes({ headers: [['host', host]] }));
      expect([400, 403]).toContain(answer.status);
      expect(answer.text).not.toContain('<title>');
    }
  });

  test('no Host at all, or several, get nothing, whatever their order and case', async () => {
    const { server } = attacked();
    const { host } = new URL(server.editorOrigin);
    await expectCallRefused({ host: null });
    for (const more of [host, 'evil.example', '']) {
      for (const name of ['Host', 'host', 'HOST']) {
        await expectCallRefused({}, [[name, more]]);
        await expectCallRefused({ host: more }, [[name, host]]);
        const page = await send(
          server.editorOrigin,
          requestBytes({
            headers: [
              ['host', host],
              [name, more],
            ],
          }),
        );
        expect([400, 403]).toContain(page.status);
      }
    }
  });

  test('what proxies say of the name counts for nothing', async () => {
    const { server } = attacked();
    const { host } = new URL(server.editorOrigin);
    for (const name of ['x-forwarded-host', 'x-host', 'forwarded', 'x-original-url', 'x-rewrite-url']) {
      await expectCallRefused({ host: 'evil.example' }, [[name, name === 'forwarded' ? `host=${host}` : host]]);
    }
  });
});

/** `@` is the editor's origin. */
const WRONG_ORIGINS = [
  ...['null', 'https://evil.example', '@/', '@.evil.example', '@@evil.example', 'https://127.0.0.1', 'http://127.0.0.1', 'file://', '@ @'],
  ...['http://localhost', 'chrome-extension://abcdefgh', 'scrim://editor', '*', ' ', '@, https://evil.example', '@%00'],
];

describe('from another page (CSRF)', () => {
  test.each(WRONG_ORIGINS)('Origin %j may not call', async (text) => {
    await expectCallRefused({ origin: text.replaceAll('@', attacked().server.editorOrigin) });
  });

  test('nor may the preview, nor who says no origin, or two', async () => {
    const { server } = attacked();
    await expectCallRefused({ origin: server.previewOrigin });
    await expectCallRefused({ origin: null });
    await expectCallRefused({ origin: null }, [['referer', `${server.editorOrigin}/`]]);
    await expectCallRefused({}, [['Origin', 'https://evil.example']]);
    await expectCallRefused({ origin: 'https://evil.example' }, [['Origin', server.editorOrigin]]);
  });

  test.each(['application/x-www-form-urlencoded', 'multipart/form-data; boundary=x', 'text/plain', 'application/json', ''])(
    'a form’s type, %j, is no message',
    async (type) => expectCallRefused({ 'content-type': type }),
  );

  test('a preflight is promised nothing', async () => {
    const { server } = attacked();
    for (const origin of ['https://evil.example', 'null', server.previewOrigin]) {
      for (const path of ['/api/call/app.info', '/api/events', SESSION_PATH, '/']) {
        const answer = await callRaw(
          server,
          { origin, 'content-length': null, [TOKEN_HEADER]: null },
          [
            ['access-control-request-method', 'POST'],
            ['access-control-request-headers', `${TOKEN_HEADER}, content-type`],
            ['access-control-request-private-network', 'true'],
          ],
          { method: 'OPTIONS', path, body: '' },
        );
        expectRefused(answer, server.token);
        expect(answer.text.toLowerCase()).not.toContain('access-control-allow');
      }
    }
  });
});

describe('with a token that is not this one', () => {
  /** Made of the right one, by what comparisons have been fooled with. */
  const WRONG_TOKENS: Readonly<Record<string, (token: string) => string>> = {
    none: () => '',
    'a shorter one': (token) => token.slice(0, -1),
    'a longer one': (token) => `${token}0`,
    'its first half': (token) => token.slice(0, 32),
    'capital letters': (token) => token.replace(/[a-f]/g, 'A'),
    twice: (token) => `${token}${token}`,
    'two in a list': (token) => `${token}, ${token}`,
    'another last digit': (token) => token.slice(0, -1) + (token.endsWith('0') ? '1' : '0'),
    quotes: (token) => `"${token}"`,
    'after a word of HTTP': (token) => `Bearer ${token}`,
    true: () => 'true',
    'an object': () => '[object Object]',
    'a very long one': () => 'f'.repeat(8000),
    zeros: () => '0'.repeat(64),
  };
  test.each(Object.keys(WRONG_TOKENS))('%s', async (name) => {
    const { server } = attacked();
    const token = WRONG_TOKENS[name]?.(server.token) ?? '';
    await expectCallRefused({ [TOKEN_HEADER]: token });
    const stream = await callRaw(server, { [TOKEN_HEADER]: token, 'content-length': null }, [], {
      method: 'GET',
      path: '/api/events',
      body: '',
    });
    expectRefused({ ...stream, text: stream.text.slice(0, 200) }, server.token);
  });

  test('the right one twice, in a cookie, in the address, or as a password', async () => {
    const { server } = attacked();
    const { token } = server;
    await expectCallRefused({}, [[TOKEN_HEADER, token]]);
    await expectCallRefused({ [TOKEN_HEADER]: null }, [['cookie', `token=${token}; ${TOKEN_HEADER}=${token}`]]);
    await expectCallRefused({ [TOKEN_HEADER]: null }, [['authorization', `Basic ${btoa(`scrim:${token}`)}`]]);
    for (const path of [`/api/call/app.info?token=${token}`, `/api/call/app.info?${TOKEN_HEADER}=${token}`, `/api/events?token=${token}`]) {
      const answer = await callRaw(server, { [TOKEN_HEADER]: null }, [], { path });
      expect(answer.status).toBe(403);
    }
  });
});

describe('with a code that is not one', () => {
  const redeem = (headers: readonly (readonly [string, string])[], changes: Changes = {}, method = 'POST') => {
    const { server } = attacked();
    const without: Changes = { [TOKEN_HEADER]: null, 'content-length': null, 'content-type': null, ...changes };
    return callRaw(server, without, headers, { method, path: SESSION_PATH, body: '' });
  };

  test.each(['', '0', '0'.repeat(32), 'f'.repeat(4000), '__proto__', 'constructor', '*', 'null'])('%j', async (code) => {
    expectRefused(await redeem([[CODE_HEADER, code]]), attacked().server.token);
  });

  test('a good one from another page, by another name, another method, or in the address, gives nothing and stays good', async () => {
    const { server } = attacked();
    const code = new URL(server.invite()).hash.slice('#code='.length);
    const given = [[CODE_HEADER, code]] as const;
    const tries = [
      await redeem(given, { origin: 'https://evil.example' }),
      await redeem(given, { origin: null }),
      await redeem(given, { origin: server.previewOrigin }),
      await redeem(given, { host: 'evil.example' }),
      await redeem(given, {}, 'GET'),
      await redeem(given, {}, 'PUT'),
      await redeem([...given, ...given]),
      await callRaw(server, { [TOKEN_HEADER]: null }, [], { path: `${SESSION_PATH}?code=${code}`, body: '' }),
    ];
    for (const answer of tries) expectRefused(answer, server.token);
    expect((await redeem(given)).text).toContain(server.token);
  });
});

describe('in another way than the page’s', () => {
  const METHODS = [
    'GET',
    'HEAD',
    'PUT',
    'PATCH',
    'DELETE',
    'OPTIONS',
    'TRACE',
    'PROPFIND',
    'SEARCH',
    'LINK',
    'post',
    'POSTX',
    'CONNECT',
    'X',
  ];
  test.each(METHODS)('%s calls nothing', async (method) => {
    const { server } = attacked();
    const answer = await callRaw(server, { 'content-length': null }, [], { method, body: '' });
    expectRefused(answer, server.token);
  });

  test.each(METHODS.filter((method) => method !== 'GET' && method !== 'HEAD'))('%s shows no page', async (method) => {
    const { server } = attacked();
    for (const origin of [server.editorOrigin, server.previewOrigin]) {
      const answer = await send(origin, requestBytes({ method, headers: [['host', new URL(origin).host]] }));
      expectRefused(answer, server.token);
      expect(answer.text).not.toContain('<title>');
    }
  });

  test.each(['websocket', 'h2c', 'TLS/1.0'])('an upgrade to %s is not made', async (protocol) => {
    const { server } = attacked();
    for (const origin of [server.editorOrigin, server.previewOrigin]) {
      for (const path of ['/', '/api/events', '/api/call/app.info']) {
        const headers = [
          ['host', new URL(origin).host],
          ['upgrade', protocol],
          ['connection', 'Upgrade'],
          ['sec-websocket-key', 'dGhlIHNhbXBsZSBub25jZQ=='],
          ['sec-websocket-version', '13'],
          ['http2-settings', 'AAMAAABkAAQAAP__'],
        ] as const;
        const answer = await send(origin, requestBytes({ path, headers }));
        expect(answer.status).not.toBe(101);
        if (path !== '/') expectRefused(answer, server.token);
      }
    }
  });
});
