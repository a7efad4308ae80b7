import { Document, NodeIO } from '@gltf-transform/core';
import { describe, expect, test } from '@jest/globals';
import { readWholeModel } from './whole-model.ts';

/** A red pixel, PNG. */
const PIXEL = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR4nGP4z8DwHwAFAAH/iZk9HQAAAABJRU5ErkJggg==', 'base64');

/** A model in two buffers and a picture, as glTF-Transform writes it into files. */
async function files(): Promise<Map<string, Uint8Array<ArrayBuffer>>> {
  const doc = new Document();
  const [first, second] = [doc.createBuffer().setURI('a.bin'), doc.createBuffer().setURI('more/b c.bin')];
  const positions = doc
    .createAccessor()
    .setType('VEC3')
    .setBuffer(first)
    .setArray(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]));
  const uvs = doc
    .createAccessor()
    .setType('VEC2')
    .setBuffer(second)
    .setArray(new Float32Array([0, 0, 1, 0, 0, 1]));
  const texture = doc.createTexture('pixel').setURI('wood.png').setImage(PIXEL).setMimeType('image/png');
  const primitive = doc.createPrimitive().setAttribute('POSITION', positions).setAttribute('TEXCOORD_0', uvs);
  primitive.setMaterial(doc.createMaterial().setBaseColorTexture(texture));
  doc.createScene().addChild(doc.createNode('tile').setMesh(doc.createMesh().addPrimitive(primitive)));
  const { json, resources } = await new NodeIO().writeJSON(doc, { basename: 'tile' });
  const found = new Map([['models/tile.gltf', new TextEncoder().encode(JSON.stringify(json))]]);
  for (const [uri, bytes] of Object.entries(resources)) found.set(`models/${decodeURIComponent(uri)}`, Uint8Array.from(bytes));
  return found;
}

async function read(found: ReadonlyMap<string, Uint8Array<ArrayBuffer>>) {
  const asked: string[] = [];
  const model = await readWholeModel(found.get('models/tile.gltf') ?? new Uint8Array(), 'models/tile.gltf', async (path) => {
    asked.push(path);
    const bytes = found.get(path);
    if (!bytes) throw new Error('there is no such file.');
    return bytes;
  });
  return { model, asked };
}

function gltf(more: object): Map<string, Uint8Array<ArrayBuffer>> {
  const document = { asset: { version: '2.0' }, scenes: [{}], ...more };
  return new Map([['models/tile.gltf', new TextEncoder().encode(JSON.stringify(document))]]);
}

describe('a model in several files', () => {
  test('is one after reading, with the same content for another reader', async () => {
    const { model, asked } = await read(await files());
    expect(asked.sort()).toEqual(['models/a.bin', 'models/more/b c.bin', 'models/wood.png']);
    const root = (await new NodeIO().readBinary(model.bytes)).getRoot();
    const [primitive] = root.listMeshes()[0]?.listPrimitives() ?? [];
    expect([...(primitive?.getAttribute('POSITION')?.getArray() ?? [])]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    expect([...(primitive?.getAttribute('TEXCOORD_0')?.getArray() ?? [])]).toEqual([0, 0, 1, 0, 0, 1]);
    const picture = primitive?.getMaterial()?.getBaseColorTexture();
    expect([picture?.getMimeType(), Buffer.from(picture?.getImage() ?? []).equals(PIXEL)]).toEqual(['image/png', true]);
    expect(root.listBuffers().length).toBe(1);
  });

  test('is told apart from one that is whole already', async () => {
    const { model } = await read(await files());
    const again = await readWholeModel(model.bytes, 'tile.glb', () => Promise.reject(new Error('nothing to read')));
    expect(again.bytes).toBe(model.bytes);
  });

  test('names the file that is missing', async () => {
    const found = await files();
    found.delete('models/wood.png');
    await expect(read(found)).rejects.toThrow(
      'the file "wood.png" that it refers to cannot be read (there is no such file). Put it beside the model, or export one .glb file.',
    );
  });

  test.each([
    'https://example.com/a.bin',
    '/etc/passwd',
    '../../secret.bin',
    '%2e%2e/%2e%2e/secret.bin',
    'a%2f..%2fb.bin',
    'C:\\a.bin',
    '%E0%A4%A.bin',
  ])('is refused where it leads out of the project: %s', async (uri) => {
    await expect(read(gltf({ buffers: [{ byteLength: 4, uri }] }))).rejects.toThrow(/^it refers to ".*", which is not in the project\./);
  });

  test('is refused where a file of it is too short', async () => {
    const found = gltf({ buffers: [{ byteLength: 40, uri: 'a.bin' }] });
    found.set('models/a.bin', new Uint8Array(10));
    await expect(read(found)).rejects.toThrow('the file is damaged: buffer 0 is too short. Export it again.');
  });

  test.each<[string, Uint8Array]>([
    ['of zeros', new Uint8Array(PIXEL.length)],
    ['cut off within its head', PIXEL.subarray(0, 12)],
  ])('is refused when a picture in it is %s', async (_what, picture) => {
    const found = (await files()).set('models/wood.png', Uint8Array.from(picture));
    await expect(read(found)).rejects.toThrow(
      'the file is damaged: image 0 is damaged or has an unsupported format. Use PNG, JPEG or WebP. Export it again.',
    );
  });

  test.each([
    ['GIF', 'GIF89a\x02\0\x02\0'],
    ['AVIF', '\0\0\0\x1cftypavif\0\0\0\x14ispe\0\0\0\0\0\0\0\x02\0\0\0\x02'],
    ['BMP', `BM${'\0'.repeat(16)}\x02\0\0\0\x02\0\0\0`],
  ])('is left alone with pictures that browsers decode, too: %s', async (_what, head) => {
    await read((await files()).set('models/wood.png', Uint8Array.from(Buffer.from(head.padEnd(60, '\0'), 'latin1'))));
  });
});
