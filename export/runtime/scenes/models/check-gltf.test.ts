import { describe, expect, test } from '@jest/globals';
import { type GltfDocument, readGltf } from './check-gltf.ts';

const MINIMAL: GltfDocument = { asset: { version: '2.0' }, scenes: [{}] };

function text(document: unknown): ArrayBuffer {
  return new TextEncoder().encode(JSON.stringify(document)).buffer as ArrayBuffer;
}

/** A GLB file; the numbers of its header can be made wrong. */
function glb(document: unknown, wrong: { version?: number; length?: number; chunkLength?: number; chunkType?: number } = {}): ArrayBuffer {
  const json = new TextEncoder().encode(JSON.stringify(document).padEnd(4));
  const bytes = new ArrayBuffer(20 + json.length);
  const view = new DataView(bytes);
  view.setUint32(0, 0x46546c67, true);
  view.setUint32(4, wrong.version ?? 2, true);
  view.setUint32(8, wrong.length ?? bytes.byteLength, true);
  view.setUint32(12, wrong.chunkLength ?? json.length, true);
  view.setUint32(16, wrong.chunkType ?? 0x4e4f534a, true);
  new Uint8Array(bytes, 20).set(json);
  return bytes;
}

describe('readGltf', () => {
  test('reads both forms of a file', () => {
    expect(readGltf(text(MINIMAL))).toEqual(MINIMAL);
    expect(readGltf(glb(MINIMAL))).toEqual(MINIMAL);
  });

  const whole = glb(MINIMAL);
  test.each<[string, ArrayBuffer, string]>([
    ['an empty file', new ArrayBuffer(0), 'it is neither a .glb nor a .gltf file.'],
    ['a picture', new Uint8Array([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]).buffer, 'it is neither a .glb nor a .gltf file.'],
    ['other JSON', text({ name: 'scrim' }), 'it is neither a .glb nor a .gltf file.'],
    ['a header alone', whole.slice(0, 12), 'the file is cut off: it should have 20 bytes and has 12. Copy or export it again.'],
    [
      'a file cut in the middle',
      whole.slice(0, 40),
      `the file is cut off: it should have ${whole.byteLength} bytes and has 40. Copy or export it again.`,
    ],
    [
      'a GLB of version 1',
      glb(MINIMAL, { version: 1 }),
      'it is a GLB file of version 1, and only version 2 can be read. Export it again as glTF 2.0.',
    ],
    [
      'a chunk beyond the file',
      glb(MINIMAL, { chunkLength: 9999 }),
      'the file is damaged: a part of it is longer than the file. Export it again.',
    ],
    ['no description', glb(MINIMAL, { chunkType: 7 }), 'the file is damaged: it does not begin with its description. Export it again.'],
    ['a broken description', glb('{').slice(0), 'the file is damaged: its description is not valid JSON. Export it again.'],
    [
      'glTF 1.0',
      text({ ...MINIMAL, asset: { version: '1.0' } }),
      'it is glTF 1.0, and only glTF 2.0 can be read. Export it again as glTF 2.0.',
    ],
    ['no scene', text({ asset: { version: '2.0' } }), 'it holds no scene, so there is nothing to show.'],
    [
      'compression, even where it could do without',
      text({ ...MINIMAL, extensionsUsed: ['KHR_draco_mesh_compression'] }),
      'it needs KHR_draco_mesh_compression, which Scrim cannot decode yet. Export it without compression, as a plain .glb.',
    ],
    [
      'extensions nobody knows',
      text({ ...MINIMAL, extensionsRequired: ['KHR_texture_basisu', 'ACME_teapots', 'KHR_materials_unlit'] }),
      'it needs KHR_texture_basisu, ACME_teapots, which Scrim cannot decode yet. Export it without compression, as a plain .glb.',
    ],
    [
      'a file beside it',
      text({ ...MINIMAL, images: [{ uri: 'wood.png' }] }),
      'it refers to another file, "wood.png". Export it as one .glb file with everything in it.',
    ],
    [
      'a buffer without content',
      text({ ...MINIMAL, buffers: [{ byteLength: 4 }] }),
      'the file is damaged: its buffer 0 has no content. Export it again.',
    ],
    [
      'a part outside its buffer',
      glb({ ...MINIMAL, buffers: [{ byteLength: 4 }], bufferViews: [{ buffer: 0, byteOffset: 2, byteLength: 4 }] }),
      'the file is damaged: its part 0 lies outside its buffer. Export it again.',
    ],
  ])('says what is wrong with %s', (_what, bytes, message) => {
    expect(() => readGltf(bytes)).toThrow(new Error(message));
  });

  test('lets pass what is used and not required', () => {
    expect(() => readGltf(text({ ...MINIMAL, extensionsUsed: ['ACME_teapots', 'EXT_meshopt_compression'] }))).not.toThrow();
  });
});
