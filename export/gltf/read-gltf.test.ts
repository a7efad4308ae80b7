import { readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import { animationNames } from './animation-names.ts';
import type { GltfDocument } from './document.ts';
import { readGltf } from './read-gltf.ts';

const MINIMAL: GltfDocument = { asset: { version: '2.0' }, scenes: [{}] };

/** One triangle of 36 bytes in a `data:` URL. */
const TRIANGLE: GltfDocument = {
  ...MINIMAL,
  meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
  accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }],
  bufferViews: [{ buffer: 0, byteLength: 36 }],
  buffers: [{ byteLength: 36, uri: `data:application/octet-stream;base64,${'A'.repeat(48)}` }],
};

/** The triangle, with entries that stand in for others. */
function sparse(wrong: object): Uint8Array {
  const right = { count: 1, indices: { bufferView: 0, componentType: 5123 }, values: { bufferView: 0 } };
  const accessor = { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', sparse: { ...right, ...wrong } };
  return text({ ...TRIANGLE, accessors: [accessor] });
}

/** A GLB whose own buffer is junk, as a part of which meshopt is told, where it is. */
function packedGlb(document: object, meshopt?: object): Uint8Array {
  const extensions = { EXT_meshopt_compression: { buffer: 0, byteLength: 8, mode: 'ATTRIBUTES', ...meshopt } };
  const bufferViews = [{ buffer: 0, byteLength: 8, ...(meshopt ? { extensions } : {}) }];
  return glb({ ...MINIMAL, buffers: [{ byteLength: 8 }], bufferViews, ...document }, {}, new Uint8Array(8));
}

function text(document: unknown): Uint8Array {
  return new TextEncoder().encode(JSON.stringify(document));
}

/** A GLB file; the numbers of its header can be made wrong. */
function glb(
  document: unknown,
  wrong: { version?: number; length?: number; chunkLength?: number; chunkType?: number } = {},
  binary?: Uint8Array,
): Uint8Array {
  const json = new TextEncoder().encode(JSON.stringify(document).padEnd(4));
  const bytes = new ArrayBuffer(20 + json.length + (binary ? 8 + binary.length : 0));
  const view = new DataView(bytes);
  view.setUint32(0, 0x46546c67, true);
  view.setUint32(4, wrong.version ?? 2, true);
  view.setUint32(8, wrong.length ?? bytes.byteLength, true);
  view.setUint32(12, wrong.chunkLength ?? json.length, true);
  view.setUint32(16, wrong.chunkType ?? 0x4e4f534a, true);
  new Uint8Array(bytes, 20).set(json);
  if (binary) {
    view.setUint32(20 + json.length, binary.length, true);
    view.setUint32(24 + json.length, 0x004e4942, true);
    new Uint8Array(bytes, 28 + json.length).set(binary);
  }
  return new Uint8Array(bytes);
}

describe('readGltf', () => {
  test('reads both forms of a file', () => {
    expect(readGltf(text(MINIMAL))).toEqual({ document: MINIMAL, binary: null });
    expect(readGltf(glb(MINIMAL))).toEqual({ document: MINIMAL, binary: null });
  });

  const whole = glb(MINIMAL);
  test.each<[string, Uint8Array, string]>([
    ['an empty file', new Uint8Array(0), 'it is neither a .glb nor a .gltf file.'],
    ['a picture', new Uint8Array([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]), 'it is neither a .glb nor a .gltf file.'],
    ['other JSON', text({ name: 'scrim' }), 'it is neither a .glb nor a .gltf file.'],
    ['a header alone', whole.slice(0, 12), 'the file is incomplete: it has 12 of 20 bytes. Copy or export it again.'],
    [
      'a file cut in the middle',
      whole.slice(0, 40),
      `the file is incomplete: it has 40 of ${whole.byteLength} bytes. Copy or export it again.`,
    ],
    [
      'a GLB of version 1',
      glb(MINIMAL, { version: 1 }),
      'it is a GLB file of version 1, but only version 2 is supported. Export it again as glTF 2.0.',
    ],
    [
      'a chunk beyond the file',
      glb(MINIMAL, { chunkLength: 9999 }),
      'the file is damaged: a chunk is longer than the file. Export it again.',
    ],
    ['no description', glb(MINIMAL, { chunkType: 7 }), 'the file is damaged: the first chunk is not JSON. Export it again.'],
    ['a broken description', glb('{').slice(0), 'the file is damaged: its JSON is invalid. Export it again.'],
    [
      'glTF 1.0',
      text({ ...MINIMAL, asset: { version: '1.0' } }),
      'it is glTF 1.0, but only glTF 2.0 is supported. Export it again as glTF 2.0.',
    ],
    ['no scene', text({ asset: { version: '2.0' } }), 'it contains no scene. Export it with a scene.'],
    [
      'extensions nobody knows',
      text({ ...MINIMAL, extensionsRequired: ['KHR_texture_basisu', 'ACME_teapots', 'KHR_materials_unlit'] }),
      'it needs ACME_teapots, which Scrim cannot decode. Export it without them.',
    ],
    [
      'a buffer without content',
      text({ ...MINIMAL, buffers: [{ byteLength: 4 }] }),
      'the file is damaged: buffer 0 has no content. Export it again.',
    ],
    [
      'a part outside its buffer',
      glb({ ...MINIMAL, buffers: [{ byteLength: 4 }], bufferViews: [{ buffer: 0, byteOffset: 2, byteLength: 4 }] }),
      'the file is damaged: buffer view 0 exceeds its buffer. Export it again.',
    ],
    [
      'a list longer than its part',
      text({ ...TRIANGLE, accessors: [{ bufferView: 0, componentType: 5126, count: 4, type: 'VEC3' }] }),
      'the file is damaged: accessor 0 exceeds its buffer view. Export it again.',
    ],
    [
      'a list of a kind that is none',
      text({ ...TRIANGLE, accessors: [{ bufferView: 0, componentType: 5130, count: 3, type: 'VEC3' }] }),
      'the file is damaged: the type of accessor 0 is invalid. Export it again.',
    ],
    [
      'a list that names no part',
      text({ ...TRIANGLE, accessors: [{ bufferView: 7, componentType: 5126, count: 3, type: 'VEC3' }] }),
      'the file is damaged: accessor 0 refers to a missing buffer view. Export it again.',
    ],
    [
      'a mesh that names no list',
      text({ ...TRIANGLE, meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 3 }] }] }),
      'the file is damaged: mesh 0 refers to a missing accessor. Export it again.',
    ],
    [
      'a buffer longer than the file',
      glb({ ...MINIMAL, buffers: [{ byteLength: 4 }] }),
      'the file is damaged: buffer 0 is longer than the file. Export it again.',
    ],
    [
      'a list of 2³⁰ zeros',
      text({ ...TRIANGLE, accessors: [{ componentType: 5126, count: 2 ** 30, type: 'VEC3' }] }),
      'the file is damaged: accessor 0 has 12288 MB, but the limit is 512 MB. Export it again.',
    ],
    [
      'a list of half an entry',
      text({ ...TRIANGLE, accessors: [{ componentType: 5126, count: 0.5, type: 'VEC3' }] }),
      'the file is damaged: accessor 0 has 0.5 elements. Export it again.',
    ],
    [
      'a sparse list that replaces 2³⁰ entries',
      sparse({ count: 2 ** 30 }),
      'the file is damaged: accessor 0 replaces 1073741824 of 3 elements. Export it again.',
    ],
    [
      'a sparse list whose values are not all there',
      sparse({ values: { bufferView: 0, byteOffset: 30 } }),
      'the file is damaged: accessor 0 exceeds its buffer view. Export it again.',
    ],
    [
      'a sparse list that names no part',
      sparse({ indices: { bufferView: 3, componentType: 5123 } }),
      'the file is damaged: accessor 0 refers to a missing buffer view. Export it again.',
    ],
    [
      'a sparse list with indices of another kind',
      sparse({ indices: { bufferView: 0, componentType: 5126 } }),
      'the file is damaged: accessor 0 does not list the elements it replaces. Export it again.',
    ],
    [
      'junk for Draco',
      packedGlb({ meshes: [{ primitives: [{ attributes: {}, extensions: { KHR_draco_mesh_compression: { bufferView: 0 } } }] }] }),
      'the file is damaged: mesh 0 is not valid Draco data. Export it again.',
    ],
    [
      'junk for meshopt',
      packedGlb({}, { count: 3, byteStride: 4 }),
      'the file is damaged: compressed buffer view 0 is not valid meshopt data. Export it again.',
    ],
    [
      'a count of 2³⁰ for meshopt',
      packedGlb({}, { count: 2 ** 30, byteStride: 4 }),
      'the file is damaged: compressed buffer view 0 has 4096 MB, but the limit is 512 MB. Export it again.',
    ],
    [
      'nothing for meshopt',
      packedGlb({}, {}),
      'the file is damaged: compressed buffer view 0 does not describe its content. Export it again.',
    ],
    [
      'a node that is its own child',
      text({ ...TRIANGLE, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, children: [1] }, { children: [1] }] }),
      'the file is damaged: node 1 contains itself. Export it again.',
    ],
    [
      'nodes in a ring',
      text({ ...TRIANGLE, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, children: [1] }, { children: [0] }] }),
      'the file is damaged: node 0 contains itself. Export it again.',
    ],
    [
      'a scene that names no node',
      text({ ...MINIMAL, scenes: [{ nodes: [2] }] }),
      'the file is damaged: the scene refers to a missing node. Export it again.',
    ],
    [
      'a node that names no node',
      text({ ...MINIMAL, nodes: [{ children: [4] }] }),
      'the file is damaged: node 0 refers to a missing node. Export it again.',
    ],
    [
      'a node that names no mesh',
      text({ ...TRIANGLE, nodes: [{ mesh: 1 }] }),
      'the file is damaged: node 0 refers to a missing mesh. Export it again.',
    ],
  ])('says what is wrong with %s', (_what, bytes, message) => {
    expect(() => readGltf(bytes)).toThrow(new Error(message));
  });

  test('knows every extension of materials that three’s loader knows', () => {
    const loader = readFileSync('node_modules/three/examples/jsm/loaders/GLTFLoader.js', 'utf8');
    const extensions = [...loader.matchAll(/KHR_MATERIALS_\w+: '(KHR_materials_\w+)'/g)].map(([, name]) => name);
    expect(extensions.length).toBeGreaterThanOrEqual(12);
    expect(() => readGltf(text({ ...MINIMAL, extensionsRequired: extensions }))).not.toThrow();
  });

  test('lets pass what is used and not required', () => {
    expect(() => readGltf(text({ ...MINIMAL, extensionsUsed: ['ACME_teapots'] }))).not.toThrow();
    expect(() => readGltf(text(TRIANGLE))).not.toThrow();
    // Two parents are one too many, and harm nobody.
    const shared = [{ children: [1, 2] }, { children: [2] }, { mesh: 0 }];
    expect(() => readGltf(text({ ...TRIANGLE, scenes: [{ nodes: [0] }], nodes: shared }))).not.toThrow();
  });
});

test('animations have the names that three.js gives them, each once', () => {
  const animations = ['Walk', undefined, 'Jump', 'Walk', ''].map((name) => ({ ...(name === undefined ? {} : { name }), samplers: [] }));
  expect(animationNames(readGltf(text({ ...MINIMAL, animations })))).toEqual(['Walk', 'animation_1', 'Jump', 'animation_4']);
  expect(animationNames(readGltf(text(MINIMAL)))).toEqual([]);
});
