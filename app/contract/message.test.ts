import { expect, test } from '@jest/globals';
import { decodeMessage, encodeMessage } from './message.ts';

test('fields and bytes come back as they went', () => {
  const fields = {
    handle: 'abc',
    name: 'Überraschung.png',
    none: null,
    nested: { list: [1, 2], deep: { on: true } },
    bytes: new Uint8Array([0, 10, 13, 255]),
    more: new Uint8Array(0),
    last: new Uint8Array([7]),
  };
  expect(decodeMessage(encodeMessage(fields))).toEqual(fields);
});

test('a message inside a larger buffer is read from where it begins', () => {
  const message = encodeMessage({ bytes: new Uint8Array([1, 2, 3]) });
  const larger = new Uint8Array(message.length + 8);
  larger.set(message, 5);
  expect(decodeMessage(larger.subarray(5, 5 + message.length))).toEqual({ bytes: new Uint8Array([1, 2, 3]) });
});

test.each([
  ['nothing', new Uint8Array(0)],
  ['a length without text', new Uint8Array([200, 0, 0, 0])],
  ['text that is no JSON', withJson('nonsense')],
  ['JSON of another shape', withJson('[1,2]')],
  ['a blob without bytes', withJson('{"value":{},"blobs":[["x",4]]}')],
  ['a blob of negative length', withJson('{"value":{},"blobs":[["x",-4]]}')],
  ['bytes that belong to nothing', new Uint8Array([...withJson('{"value":{},"blobs":[]}'), 1])],
])('throws on %s', (_name, message) => {
  expect(() => decodeMessage(message)).toThrow();
});

test('a field cannot reach the prototype', () => {
  const decoded = decodeMessage(withJson('{"value":{"__proto__":{"polluted":true}},"blobs":[]}'));
  expect(({} as { polluted?: boolean }).polluted).toBeUndefined();
  expect(Object.getPrototypeOf(decoded)).toBe(Object.prototype);
});

function withJson(json: string): Uint8Array {
  const bytes = new TextEncoder().encode(json);
  return new Uint8Array([bytes.length, 0, 0, 0, ...bytes]);
}
