import { resolve } from 'node:path';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { encode } from 'jpeg-js';
import { captureMeshFile, meshCounts, readCapture } from '../../../nodes/kit/capture.ts';
import { plyFile, plyOf, splatAt } from '../../../tests/support/splat-files.ts';
import { texturedModel } from '../../../tests/support/textured-model.ts';
import { sogOf } from '../../../tools/examples/splats/write-sog.ts';
import type { ProgramAsset } from '../../program/program.ts';
import { chooseForms } from './choose-forms.ts';
import type { AssetCache } from './model-cache.ts';
import { type AssetOptions, type PreparedAssets, prepareAssets } from './prepare-assets.ts';

const BALL: ProgramAsset = { id: 'ball', kind: 'model', path: 'assets/ball.glb' };
const PICTURE: ProgramAsset = { id: 'picture', kind: 'image', path: 'assets/a picture.png' };
let ball: Uint8Array;
beforeAll(async () => {
  ball = await texturedModel(64);
});

/** A PNG's head: 20 × 10 pixels. */
const PNG = Buffer.from('89504e470d0a1a0a0000000d49484452000000140000000a', 'hex');

async function prepare(more: Partial<AssetOptions> = {}, assets = [BALL, PICTURE]) {
  const said: string[] = [];
  const { output, diagnostics } = await prepareAssets(assets, {
    root: resolve(import.meta.dirname, '../../..'),
    readAsset: async (path) => (path.endsWith('.png') ? PNG : ball),
    compress: true,
    cache: null,
    streams: true,
    say: (text) => said.push(text),
    ...more,
  });
  return { output: output as PreparedAssets, diagnostics, said };
}

describe('the assets of a page', () => {
  test('are compressed, and reported before and after', async () => {
    const { output, diagnostics, said } = await prepare();
    expect(diagnostics).toEqual([]);
    expect(said).toEqual(['Compressing assets/ball.glb (1 of 1)…']);
    expect(output.decoders).toEqual(['meshopt']);
    expect(output.decoderFiles).toEqual([]);
    const [model, picture] = output.assets;
    expect(model?.report).toMatchObject({ source: 'assets/ball.glb', path: model?.path, kind: 'model', form: 'meshopt' });
    const { fileBytes, gpuBytes } = model?.report ?? { fileBytes: { before: 0, after: 0 }, gpuBytes: { before: 0, after: 0 } };
    expect([fileBytes.before, fileBytes.after]).toEqual([ball.length, model?.bytes.length]);
    expect(fileBytes.after).toBeLessThan(0.6 * fileBytes.before);
    // 32-bit floats become 16-bit numbers; the picture and the morph target stay.
    expect(gpuBytes.after).toBeLessThan(0.9 * gpuBytes.before);
    expect(picture?.path).toMatch(/^assets\/a-picture-[0-9a-f]{10}\.png$/);
    expect(picture?.report).toMatchObject({
      form: 'original',
      fileBytes: { before: PNG.length, after: PNG.length },
      gpuBytes: { before: 800, after: 800 },
    });
  });

  test('stay as they are where that is asked', async () => {
    const { output, said } = await prepare({ compress: false });
    expect([output.assets[0]?.bytes, output.assets[0]?.report.form, output.decoders, said]).toEqual([ball, 'original', [], []]);
  });

  test('are compressed once: the next export finds them', async () => {
    const kept = new Map<string, Uint8Array>();
    const cache: AssetCache = {
      read: async (name) => kept.get(name) ?? null,
      write: async (name, bytes) => void kept.set(name, bytes),
    };
    const first = await prepare({ cache });
    const second = await prepare({ cache });
    expect(second.said).toEqual([]);
    expect(second.output.assets).toEqual(first.output.assets);
    const [name = '', bytes = new Uint8Array()] = [...kept][0] ?? [];
    kept.set(name, bytes.subarray(0, bytes.length - 10));
    // A file that was cut off counts as none.
    expect((await prepare({ cache })).output.assets).toEqual(first.output.assets);
  });

  test('survive a cache that fails', async () => {
    const fail = () => Promise.reject(new Error('the disk is full'));
    const { output, diagnostics } = await prepare({ cache: { read: fail, write: fail } });
    expect([output.assets[0]?.report.form, diagnostics]).toEqual(['meshopt', []]);
  });

  test('stay as they are, with a warning, where they cannot be compressed', async () => {
    // No bundle of the compressor can be made of sources that are not there.
    const { output, diagnostics } = await prepare({ root: '/nowhere' });
    expect(output.assets[0]?.report.form).toBe('original');
    expect(diagnostics).toMatchObject([{ code: 'SCR036', severity: 'warning', file: 'assets/ball.glb' }]);
  });

  test('are refused where they cannot be read, or are no models', async () => {
    const missing = await prepare({ readAsset: () => Promise.reject(new Error('there is no such file')) }, [PICTURE]);
    expect([missing.output, missing.diagnostics]).toMatchObject([null, [{ code: 'SCR030', file: 'assets/a picture.png' }]]);
    const broken = await prepare({ readAsset: async () => ball.subarray(0, 1000) }, [BALL]);
    expect([broken.output, broken.diagnostics]).toMatchObject([
      null,
      [{ code: 'SCR032', message: expect.stringContaining('is incomplete') }],
    ]);
  });
});

describe('which form a page has of its models', () => {
  test('none that costs more than it saves', () => {
    const forms = { original: ball, compressed: { meshopt: ball.slice(), ktx2: null } };
    expect(chooseForms([forms])[0]?.form).toBe('original');
  });

  test('KTX2 where it saves graphics memory that is worth its decoder', async () => {
    const big = await texturedModel(1024);
    const { output } = await prepare({ readAsset: async () => big }, [BALL]);
    expect(output.decoders).toEqual(['meshopt', 'ktx2']);
    expect(output.decoderFiles.map(({ path }) => path)).toEqual([
      expect.stringMatching(/^decoders\/basis_transcoder-[0-9a-f]{10}\.js$/),
      expect.stringMatching(/^decoders\/basis_transcoder-[0-9a-f]{10}\.wasm$/),
    ]);
    const { gpuBytes } = output.assets[0]?.report ?? { gpuBytes: { before: 0, after: 1 } };
    expect(gpuBytes.after).toBeLessThan(0.4 * gpuBytes.before);
  });
});

describe('a capture', () => {
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const view = {
    file: 'views/000.jpg',
    widthPx: 640,
    heightPx: 480,
    fxPx: 500,
    fyPx: 500,
    cxPx: 320,
    cyPx: 240,
    worldFromCamera: identity,
  };
  const mesh = { positions: Float32Array.of(0, 0, -1, 1, 0, -1, 0, 1, -1), indices: Uint32Array.of(0, 1, 2) };
  const document = { format: 'scrim-capture', version: 1, mesh: { file: 'mesh.bin', ...meshCounts(mesh) }, views: [view] };
  const place: ProgramAsset = { id: 'place', kind: 'capture', path: 'assets/place.capture/capture.json' };
  // Bytes that no JPEG encoder writes, so that the photograph has 600 KB after its first lines.
  const photo = Buffer.concat([
    encode({ width: 640, height: 480, data: new Uint8Array(4 * 640 * 480).fill(99) }, 90).data,
    Buffer.alloc(600_000),
  ]);
  const files: Readonly<Record<string, Uint8Array>> = {
    'capture.json': Buffer.from(JSON.stringify(document)),
    'mesh.bin': captureMeshFile(mesh),
    '000.jpg': photo,
  };
  const readAsset = async (path: string) => files[path.slice(path.lastIndexOf('/') + 1)] ?? new Uint8Array();

  test('has a reduced form in a page that streams, and not in a page of one file', async () => {
    const streamed = await prepare({ readAsset }, [place]);
    expect(streamed.diagnostics).toEqual([]);
    const written = readCapture(new TextDecoder().decode(streamed.output.assets[0]?.bytes));
    expect(written.coarseMesh?.triangleCount).toBe(1);
    expect(written.phoneGpuBytes).toBe(128e6);
    expect(streamed.output.assets[0]?.report.gpuBytes.onPhones).toBeLessThan(128e6);
    expect(written.views[0]?.reducedFile).toMatch(/-reduced-[0-9a-f]{10}\.avif$/);
    const alone = await prepare({ readAsset, streams: false }, [place]);
    expect(readCapture(new TextDecoder().decode(alone.output.assets[0]?.bytes))).toEqual({
      ...written,
      coarseMesh: undefined,
      views: [{ ...written.views[0], reducedFile: undefined }],
    });
    expect([alone.said, alone.output.assets[0]?.others.length]).toEqual([[], 2]);
  });

  test('has its depth meshes and hidden meshes only in a page that draws them', async () => {
    const counts = { widthPx: 640, heightPx: 480, vertexCount: 3, triangleCount: 1 };
    const depthMesh = { file: 'depth-meshes/000.bin', ...counts };
    const hiddenMesh = { file: 'hidden-meshes/000-hidden.bin', ...counts };
    const withMeshes = { ...document, version: 3, views: [{ ...view, depthMesh, hiddenMesh }] };
    const more: typeof files = {
      ...files,
      'capture.json': Buffer.from(JSON.stringify(withMeshes)),
      '000.bin': Buffer.alloc(36),
      '000-hidden.bin': Buffer.alloc(48),
    };
    const read = async (path: string) => more[path.slice(path.lastIndexOf('/') + 1)] ?? new Uint8Array();
    const drawn = await prepare({ readAsset: read, streams: false }, [{ ...place, depthMeshes: true }]);
    const [{ depthMesh: depth, hiddenMesh: hidden } = {}] = readCapture(new TextDecoder().decode(drawn.output.assets[0]?.bytes)).views;
    const paths = drawn.output.assets[0]?.others.map(({ path, bytes }) => [path.slice('assets/'.length), bytes.length]) ?? [];
    expect(paths).toEqual(expect.arrayContaining([depth?.file, hidden?.file].map((file, i) => [file, i === 0 ? 36 : 48])));
    const plain = await prepare({ readAsset: read, streams: false }, [place]);
    expect(plain.output.assets[0]?.others).toHaveLength(2);
    expect(new TextDecoder().decode(plain.output.assets[0]?.bytes)).not.toMatch(/depthMesh|hiddenMesh/);
  });
});

describe('splats', () => {
  const splats = Array.from({ length: 500 }, (_, i) =>
    splatAt(Math.sin(i), Math.cos(3 * i), 0.01 * i, { harmonics: new Array(45).fill(0.01) }),
  );
  const prepareFile = (path: string, bytes: Uint8Array) =>
    prepare({ readAsset: async () => bytes }, [{ id: 'splats', kind: 'splats', path }]);

  test('of a PLY file are packed for the graphics card, and reported in bytes', async () => {
    const ply = plyOf(splats);
    const { output, diagnostics } = await prepareFile('assets/garden.ply', ply);
    expect(diagnostics).toEqual([]);
    expect(output.assets[0]?.path).toMatch(/^assets\/garden-[0-9a-f]{10}\.splats$/);
    expect(output.assets[0]?.report).toMatchObject({ kind: 'splats', fileBytes: { before: ply.length }, gpuBytes: { after: 500 * 84 } });
    expect(output.assets[0]?.report.fileBytes.after).toBeLessThan(ply.length / 8);
    const again = await prepareFile('assets/garden.ply', ply);
    expect(again.output.assets[0]?.bytes).toEqual(output.assets[0]?.bytes);
  });

  test('of a SOG file stay as they are', async () => {
    const sog = await sogOf(splats);
    const { output } = await prepareFile('assets/garden.sog', sog);
    expect(output.assets[0]?.path).toMatch(/^assets\/garden-[0-9a-f]{10}\.sog$/);
    expect(output.assets[0]?.bytes).toEqual(sog);
  });

  test('that are none are refused with what to do', async () => {
    const { output, diagnostics } = await prepareFile('assets/points.ply', plyFile(1, ['x', 'y', 'z'], [0, 0, 0]));
    expect(output).toBeNull();
    expect(diagnostics).toMatchObject([{ code: 'SCR032', severity: 'error', file: 'assets/points.ply' }]);
    expect(diagnostics[0]?.fix).toContain('point_cloud.ply');
  });
});
