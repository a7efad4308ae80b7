import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { findOpaqueModels } from './opaque-models.ts';

let root: string;
beforeAll(async () => {
  root = await mkdtemp(join(tmpdir(), 'scrim-opaque-'));
});
afterAll(() => rm(root, { recursive: true, force: true }));

/** A GLB file of a document and an empty binary chunk. */
function glb(document: object): Buffer {
  const text = Buffer.from(JSON.stringify(document));
  const json = Buffer.concat([text, Buffer.alloc(-text.length & 3, ' ')]);
  const head = Buffer.alloc(20);
  head.write('glTF');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(28 + json.length, 8);
  head.writeUInt32LE(json.length, 12);
  head.write('JSON', 16);
  const binary = Buffer.alloc(8);
  binary.write('BIN\0', 4);
  return Buffer.concat([head, json, binary]);
}

test('models without transparent materials and without glass are found', async () => {
  const files: Record<string, object> = {
    plain: { materials: [{}, { alphaMode: 'OPAQUE' }, { alphaMode: 'MASK', alphaCutoff: 0.3 }] },
    bare: {},
    blended: { materials: [{}, { alphaMode: 'BLEND' }] },
    glass: { materials: [{ extensions: { KHR_materials_transmission: { transmissionFactor: 1 } } }] },
    coated: { materials: [{ extensions: { KHR_materials_clearcoat: {} } }] },
  };
  for (const [name, document] of Object.entries(files)) {
    await writeFile(join(root, `${name}.glb`), glb(document));
    await writeFile(join(root, `${name}.gltf`), JSON.stringify(document));
  }
  await writeFile(join(root, 'cut.glb'), glb(files.plain ?? {}).subarray(0, 40));
  await writeFile(join(root, 'null.gltf'), '{ "materials": [null] }');
  const names = Object.keys(files).flatMap((name) => [`${name}.glb`, `${name}.gltf`]);
  const assets = Object.fromEntries(
    [...names, 'cut.glb', 'null.gltf', 'missing.glb', '../outside.glb'].map((path) => [path, { path, kind: 'model' as const }]),
  );
  expect(await findOpaqueModels(root, { ...assets, image: { path: 'plain.glb', kind: 'image' } })).toEqual([
    'plain.glb',
    'plain.gltf',
    'bare.glb',
    'bare.gltf',
    'coated.glb',
    'coated.gltf',
  ]);
});
