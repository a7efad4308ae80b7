import { Document, NodeIO } from '@gltf-transform/core';
import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, BufferGeometry, Float32BufferAttribute, PlaneGeometry, SphereGeometry } from 'three';
import { findingsOf } from './findings.ts';
import { imageSize } from './image-size.ts';
import { measureModel } from './measure.ts';
import { findEdgeFaults, mayHaveBorders } from './open-edges.ts';
import { readGltf } from './read-gltf.ts';

async function model(geometry: BufferGeometry, picture?: Uint8Array) {
  const doc = new Document();
  doc.createBuffer();
  const list = (name: string) => geometry.getAttribute(name).array as Float32Array;
  const primitive = doc
    .createPrimitive()
    .setAttribute('POSITION', doc.createAccessor().setType('VEC3').setArray(list('position')))
    .setAttribute('NORMAL', doc.createAccessor().setType('VEC3').setArray(list('normal')));
  if (geometry.index) primitive.setIndices(doc.createAccessor().setType('SCALAR').setArray(Uint32Array.from(geometry.index.array)));
  if (picture) {
    const texture = doc.createTexture().setImage(picture).setMimeType('image/png');
    primitive.setMaterial(doc.createMaterial().setBaseColorTexture(texture));
  }
  doc.createScene().addChild(doc.createNode().setMesh(doc.createMesh().addPrimitive(primitive)));
  return readGltf(await new NodeIO().writeBinary(doc));
}

/** A PNG of this size that says nothing of its pixels. */
function emptyPng(widthPx: number, heightPx: number): Uint8Array {
  const bytes = Buffer.alloc(45);
  bytes.write('\x89PNG\r\n\x1a\n\0\0\0\rIHDR', 'latin1');
  bytes.writeUInt32BE(widthPx, 16);
  bytes.writeUInt32BE(heightPx, 20);
  bytes.write('IEND', 37, 'latin1');
  return bytes;
}

describe('edges', () => {
  test.each([
    ['a box, whose faces share no vertices', new BoxGeometry(1, 1, 1, 3, 2, 1), { open: 0, branching: 0 }],
    // Its rim: 4 sides of 5 edges.
    ['a sheet of 5 × 5 squares', new PlaneGeometry(1, 1, 5, 5), { open: 20, branching: 0 }],
    // Its seam closes but for rounding.
    ['half a sphere', new SphereGeometry(1, 16, 8, 0, 2 * Math.PI, 0, Math.PI / 2), { open: 16, branching: 0 }],
  ])('of %s', async (_, geometry, faults) => {
    expect(findEdgeFaults(await model(geometry))).toMatchObject(faults);
  });

  test('where three sheets meet', async () => {
    const fan = new BufferGeometry();
    fan.setAttribute('position', new Float32BufferAttribute([0, 0, 0, 0, 1, 0, 1, 0, 0, -1, 0, 0, 0, 0, 1], 3));
    fan.setAttribute('normal', new Float32BufferAttribute(new Float32Array(15), 3));
    fan.setIndex([0, 1, 2, 0, 1, 3, 0, 1, 4]);
    expect(findEdgeFaults(await model(fan))).toEqual({ open: 6, branching: 1 });
  });
});

describe('whether a model may have borders', () => {
  test.each([
    ['a box, whose faces share no vertices', new BoxGeometry(1, 1, 1, 3, 2, 1), false],
    ['a sphere, whose seam and poles close but for rounding', new SphereGeometry(0.3, 48, 32), false],
    ['a sheet', new PlaneGeometry(), true],
    ['half a sphere', new SphereGeometry(1, 16, 8, 0, 2 * Math.PI, 0, Math.PI / 2), true],
  ])('%s', async (_, geometry, expected) => {
    expect(mayHaveBorders(await model(geometry))).toBe(expected);
  });

  test('a box with one face of another material, and one whose lid opens by a morph target', async () => {
    const box = await model(new BoxGeometry());
    const { document } = box;
    const [mesh] = document.meshes ?? [];
    const [primitive] = mesh?.primitives ?? [];
    if (!primitive) throw new Error('The model has no primitive.');
    const [positions] = document.accessors ?? [];
    const position = primitive.attributes.POSITION ?? 0;
    const morphed = (target: number) =>
      mayHaveBorders({ ...box, document: { ...document, meshes: [{ primitives: [{ ...primitive, targets: [{ POSITION: target }] }] }] } });
    // The normals move the faces apart.
    expect(morphed(primitive.attributes.NORMAL ?? 0)).toBe(true);
    expect(morphed(position)).toBe(false);
    const index = document.accessors?.[primitive.indices ?? -1];
    if (!index || !positions) throw new Error('The model has no index.');
    const accessors = (document.accessors ?? []).map((one) => (one === index ? { ...one, count: one.count - 6 } : one));
    expect(mayHaveBorders({ ...box, document: { ...document, accessors } })).toBe(true);
  });
});

describe('the findings on a model', () => {
  test('are empty for a closed, small one', async () => {
    expect(findingsOf(await model(new BoxGeometry()), 'box.glb', 2000, true)).toEqual([]);
  });

  test('say that it is huge, with numbers', async () => {
    const geometry = new SphereGeometry(1, 500, 400);
    const findings = findingsOf(await model(geometry, emptyPng(8192, 8192)), 'big.glb', 50e6, false);
    expect(findings.map(({ code, severity, message }) => `${code} ${severity} ${message}`)).toEqual([
      'SCR034 warning The model "big.glb" has 399,000 triangles; above 300,000 phones draw it slowly.',
      'SCR034 warning The model "big.glb" has a texture of 67.1 million pixels; above 16.8 million pixels not every phone can show it.'.replace(
        '16.8 million pixels',
        '16.8',
      ),
      expect.stringMatching(/^SCR034 warning The model "big.glb" takes about \d+ MB of graphics memory, 358 of them for textures;/),
      'SCR034 warning The model "big.glb" has 50 MB; above 32 MB visitors wait long.',
    ]);
  });

  test('is that it has holes, where it stands for a real thing', async () => {
    const sheet = await model(new PlaneGeometry(1, 1, 5, 5));
    expect(findingsOf(sheet, 'wall.glb', 2000, false)).toEqual([]);
    expect(findingsOf(sheet, 'wall.glb', 2000, true)).toMatchObject([
      { code: 'SCR035', severity: 'warning', message: expect.stringContaining('it has 20 edges at holes or borders.') },
    ]);
  });

  test('measures what the GPU holds', async () => {
    // 24 vertices of 24 bytes and 36 indices of 4; a picture with its mip maps.
    const { geometryBytes, textureBytes, triangles } = measureModel(await model(new BoxGeometry(), emptyPng(64, 32)));
    expect([triangles, geometryBytes, textureBytes]).toEqual([12, 24 * 24 + 36 * 4, Math.round((64 * 32 * 4 * 4) / 3)]);
  });
});

test.each([
  ['PNG', emptyPng(7, 9), [7, 9]],
  ['JPEG', Buffer.from('ffd8ffe000044a46ffc2000b08000900070000', 'hex'), [7, 9]],
  ['lossy WebP', Buffer.from('52494646000000005745425056503820000000000000009d012a07000900', 'hex'), [7, 9]],
  ['lossless WebP', Buffer.from('5249464600000000574542505650384c000000002f06000200', 'hex'), [7, 9]],
  ['extended WebP', Buffer.from('524946460000000057454250565038580000000000000000060000080000', 'hex'), [7, 9]],
])('the size of a %s file', (_, bytes, [widthPx, heightPx]) => {
  expect(imageSize(bytes)).toEqual({ widthPx, heightPx, ktx2: null });
  expect(imageSize(bytes.subarray(0, 6))).toBeNull();
});
