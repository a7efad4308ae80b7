import { expect, test } from '@jest/globals';
import { openSog } from '../../../nodes/kit/splats/sog-archive.ts';
import { splatAt } from '../../../tests/support/splat-files.ts';
import { sogFilesOf } from '../../../tools/examples/splats/write-sog.ts';
import { packSog } from './whole-sog.ts';

const fileOf = (name: string, bytes: Uint8Array = new Uint8Array()) => ({
  name,
  arrayBuffer: async () => Uint8Array.from(bytes).buffer,
});
const dropped = async () => [...(await sogFilesOf([splatAt(0, 0, 0), splatAt(1, 0, 0)]))].map(([name, bytes]) => fileOf(name, bytes));

test('the document and images of splats that are dropped together become one file; other files stay', async () => {
  const photo = fileOf('photo.webp');
  const { sog, problem, rest } = await packSog([photo, ...(await dropped())]);
  expect(problem).toBeNull();
  expect(rest).toEqual([photo]);
  expect((await openSog(sog?.bytes ?? new Uint8Array())).meta.count).toBe(2);
});

test('a missing image is named, and none of the others is imported as a picture', async () => {
  const files = (await dropped()).filter(({ name }) => name !== 'sh0.webp');
  const { sog, problem, rest } = await packSog(files);
  expect([sog, rest]).toEqual([null, []]);
  expect(problem).toBe('meta.json cannot be imported as splats: its sh0.webp is missing. Choose it together with its images.');
});

test('files without such a document are left alone', async () => {
  const files = [fileOf('a.webp'), fileOf('data.json')];
  expect(await packSog(files)).toEqual({ sog: null, problem: null, rest: files });
});
