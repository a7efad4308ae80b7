import { connect, type Socket } from 'node:net';
import { describe, expect, test } from '@jest/globals';
import { callHeaders, callRaw, expectRefused, MAX_MESSAGE_BYTES, requestBytes, send, useAttackedServer } from './server-kit.ts';

const attacked = useAttackedServer();

async function expectMessageRefused(body: string | Uint8Array, method = 'project.open'): Promise<void> {
  const { server } = attacked();
  const length = typeof body === 'string' ? Buffer.byteLength(body) : body.length;
  const answer = await callRaw(server, { 'content-length': String(length) }, [], { path: `/api/call/${method}`, body });
  expectRefused(answer, server.token);
  expect(answer.status).not.toBeNull();
}

/** See `app/contract/message.ts`; each of these is broken in another place. */
const DAMAGED: Readonly<Record<string, string | Uint8Array>> = {
  nothing: '',
  'one byte': 'x',
  'a length and no more': new Uint8Array(4),
  'a length beyond the end': new Uint8Array([255, 255, 255, 255, 123, 125]),
  'a negative length': new Uint8Array([0, 0, 0, 128, 123, 125]),
  'plain JSON': '{"path":"/"}',
  'an array': withLength('[]'),
  'a text': withLength('"x"'),
  'half of an object': withLength('{"value":{"path":'),
  'bytes that are no UTF-8': withLength(new Uint8Array([0x7b, 0x22, 0xff, 0xfe, 0x22, 0x3a, 0x31, 0x7d])),
  'arrays in arrays, 100,000 deep': withValue(`{"path":${'['.repeat(100_000)}${']'.repeat(100_000)}}`),
  'objects in objects, 50,000 deep': withValue(`${'{"a":'.repeat(50_000)}1${'}'.repeat(50_000)}`),
  'an envelope without bytes': withLength('{"value":{"path":"/"}}'),
  'bytes beyond its end': withValue('{}', '[["path",1000]]'),
  'bytes of a negative length': withValue('{}', '[["path",-1]]'),
  'bytes of no whole length': withValue('{}', '[["path",0.5]]'),
  'bytes for its prototype': withValue('{}', '[["__proto__",0]]'),
  '80,000 lists of no bytes': withValue('{}', `[${'["a",0],'.repeat(80_000)}["a",0]]`),
  'a number beyond numbers': withValue('{"path":1e999}'),
  'a prototype': withValue('{"__proto__":{"path":"/","isAdmin":true}}'),
  'a constructor': withValue('{"constructor":{"prototype":{"path":"/"}}}'),
  'a path with NUL': withValue('{"path":"/tmp\\u0000/x"}'),
  'a very long path': withValue(JSON.stringify({ path: '/'.padEnd(500_000, 'a/') })),
  'a path that is not whole': withValue('{"path":"../../etc"}'),
  'a path to a file that is no project': withValue('{"path":"/etc/passwd"}'),
  'a path to a device': withValue('{"path":"/dev/zero"}'),
};

function withValue(value: string, blobs = '[]'): Uint8Array {
  return withLength(`{"value":${value},"blobs":${blobs}}`);
}

function withLength(json: string | Uint8Array): Uint8Array {
  const bytes = typeof json === 'string' ? Buffer.from(json) : json;
  const head = Buffer.alloc(4);
  head.writeUInt32LE(bytes.length);
  return Buffer.concat([head, bytes]);
}

describe('a message', () => {
  test.each(Object.keys(DAMAGED))('that is %s is refused in words', async (name) => {
    await expectMessageRefused(DAMAGED[name] ?? '');
    expect(({} as { isAdmin?: boolean }).isAdmin).toBeUndefined();
  });

  const METHODS = ['', 'x', 'constructor', '__proto__', 'toString', 'hasOwnProperty', 'app', 'app.', 'app.info/', 'app.info.x', 'APP.INFO'];
  test.each([...METHODS, 'app%2einfo', '../call/app.info', 'app.info%00', 'app.info#x', 'a'.repeat(5000)])(
    'to the method %j reaches nothing',
    async (method) => expectMessageRefused(withValue('{}'), method),
  );
});

describe('a body', () => {
  const over = MAX_MESSAGE_BYTES + 1;

  test('that its header calls too large is refused before it is read', async () => {
    const { server } = attacked();
    for (const length of [over, 2 ** 31, 2 ** 40, Number.MAX_SAFE_INTEGER]) {
      const answer = await send(
        server.editorOrigin,
        requestBytes({ method: 'POST', path: '/api/call/app.info', headers: callHeaders(server, { 'content-length': String(length) }) }),
      );
      expect(answer.status).toBe(413);
    }
  });

  test('that grows too large in pieces is refused', async () => {
    const { server } = attacked();
    const piece = `10000\r\n${'x'.repeat(0x10000)}\r\n`;
    const answer = await callRaw(server, { 'content-length': null, 'transfer-encoding': 'chunked' }, [], {
      body: `${piece.repeat(17)}0\r\n\r\n`,
    });
    // It may close while the rest is still being sent.
    expect([413, null]).toContain(answer.status);
    expectRefused(answer, server.token);
  });

  test.each([
    ['two lengths', { 'content-length': '4' }, [['content-length', '6']]],
    ['a length and pieces', {}, [['transfer-encoding', 'chunked']]],
    ['a length in words', { 'content-length': 'four' }, []],
    ['a negative length', { 'content-length': '-1' }, []],
    ['a length with a sign', { 'content-length': '+6' }, []],
    ['a length in hexadecimal', { 'content-length': '0x6' }, []],
    ['a list of lengths', { 'content-length': '6, 6' }, []],
    ['pieces in another coding', { 'content-length': null, 'transfer-encoding': 'gzip, chunked' }, []],
    ['an unknown coding', { 'content-length': null, 'transfer-encoding': 'xchunked' }, []],
    ['pieces with a broken length', { 'content-length': null, 'transfer-encoding': 'chunked' }, []],
  ] as const)('with %s is no request, and hides none behind it', async (_name, changes, more) => {
    const { server } = attacked();
    const { host } = new URL(server.editorOrigin);
    const answer = await callRaw(server, changes, more, { body: `G\r\nGET /secret HTTP/1.1\r\nhost: ${host}\r\n\r\n` });
    expectRefused(answer, server.token);
    expect(answer.text.split('HTTP/1.1 ').length).toBeLessThanOrEqual(2);
  });
});

describe('a head', () => {
  const line = (first: string, ...headers: string[]) => `${[first, ...headers].join('\r\n')}\r\n\r\n`;
  const BROKEN: Readonly<Record<string, (host: string) => string>> = {
    'without a version': (host) => line('GET /', `host: ${host}`),
    'of HTTP/0.9': () => 'GET /\r\n\r\n',
    'of HTTP/2': () => 'PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n',
    'of HTTP/9.9': (host) => line('GET / HTTP/9.9', `host: ${host}`),
    'of TLS': () => '\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n',
    'of SSH': () => 'SSH-2.0-OpenSSH_9.6\r\n\r\n',
    'of NULs': () => '\0'.repeat(1000),
    'with a space before the colon': (host) => line('GET / HTTP/1.1', `host : ${host}`),
    'with a folded line': (host) => line('GET / HTTP/1.1', 'host:', ` ${host}`),
    'with a NUL in a value': (host) => line('GET / HTTP/1.1', `host: ${host}`, 'x: a\0b'),
    'with a bare return in a value': (host) => line('GET / HTTP/1.1', `host: ${host}`, 'x: a\rb: c'),
    'with a name of no letters': (host) => line('GET / HTTP/1.1', `host: ${host}`, '@: 1'),
    'with an empty name': (host) => line('GET / HTTP/1.1', `host: ${host}`, ': 1'),
    'with a line that is none': (host) => line('GET / HTTP/1.1', `host: ${host}`, 'nonsense'),
    'with a value of 64 KB': (host) => line('GET / HTTP/1.1', `host: ${host}`, `x: ${'a'.repeat(65_536)}`),
    'with 5,000 lines': (host) => line('GET / HTTP/1.1', `host: ${host}`, ...Array.from({ length: 5000 }, (_, i) => `x${i}: 1`)),
    'with an address of 64 KB': (host) => line(`GET /${'a'.repeat(65_536)} HTTP/1.1`, `host: ${host}`),
    'with a raw space in its address': (host) => line('GET /a b HTTP/1.1', `host: ${host}`),
    'with a method of 10,000 letters': (host) => line(`${'G'.repeat(10_000)} / HTTP/1.1`, `host: ${host}`),
  };
  test.each(Object.keys(BROKEN))('%s is refused, on both ports', async (name) => {
    const { server } = attacked();
    for (const origin of [server.editorOrigin, server.previewOrigin]) {
      const answer = await send(origin, Buffer.from(BROKEN[name]?.(new URL(origin).host) ?? '', 'latin1'));
      expectRefused(answer, server.token);
      expect(answer.text).not.toContain('<title>');
    }
  });
});

test('two hundred silent connections do not block another one', async () => {
  const { server } = attacked();
  const { hostname, port } = new URL(server.editorOrigin);
  const sockets: Socket[] = [];
  try {
    for (let i = 0; i < 200; i++) {
      const socket = connect({ host: hostname, port: Number(port) });
      sockets.push(socket);
      await new Promise((resolve) => socket.once('connect', resolve));
      // Half of a head, as slow attacks send.
      socket.write('GET / HTTP/1.1\r\nx: ');
    }
    expect((await callRaw(server, {})).status).toBe(200);
  } finally {
    for (const socket of sockets) socket.destroy();
  }
});
