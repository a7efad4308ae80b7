import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { draco } from '@gltf-transform/functions';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import draco3d from 'draco3dgltf';
import { type Compressor, createCompressor } from '../../export/bundle/compress/compressor.ts';
import { DECODER_FILES_FOLDER, neededDecoders } from '../../export/gltf/decoders.ts';
import { readGltf } from '../../export/gltf/read-gltf.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { texturedModel } from '../support/textured-model.ts';

const chromium = useBrowser();
let folder = '';
let page: PageModule;
let compressor: Compressor;

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'scrim-models-'));
  compressor = createCompressor(process.cwd());
  await writeFile(join(folder, 'ball.glb'), await texturedModel(256));
  page = await openModule(chromium.browser, 'tests/browser/compressed-models.page.ts', {
    mounts: { '/models/': folder, '/libs/': resolve(DECODER_FILES_FOLDER) },
  });
  expect(await page.call('applyPolicy')).toBe('refused');
});
afterAll(async () => {
  await compressor.dispose();
  await page.close();
  // Those of `applyPolicy`, by which the policy was seen to hold, and the file that a test took away.
  expect(page.errors.filter((error) => !/blob:|404/.test(error))).toEqual([]);
  await rm(folder, { recursive: true, force: true });
});

interface Facts {
  readonly names: readonly string[];
  readonly clips: readonly string[];
  readonly bones: number;
  readonly morphs: number;
  readonly packedTextures: number;
}

interface Comparison {
  readonly covered: number;
  /** Mean over the covered pixels of the worst channel's difference, of 255. */
  readonly mean: number;
  /** Share of them that differ by more than 24. */
  readonly far: number;
  readonly before: Facts;
  readonly after: Facts;
  readonly error: number;
}

/** Writes the forms of a model beside it: `NAME-meshopt.glb` and `NAME-ktx2.glb`. */
async function compress(name: string) {
  const bytes = new Uint8Array(await readFile(join(folder, `${name}.glb`)));
  const forms = await compressor.compress(bytes);
  for (const form of ['meshopt', 'ktx2'] as const) {
    const made = forms[form];
    if (made) await writeFile(join(folder, `${name}-${form}.glb`), made);
  }
  return { bytes, ...forms };
}

async function writeDraco(name: string): Promise<Uint8Array> {
  const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
    'draco3d.encoder': await draco3d.createEncoderModule(),
  });
  const doc = await io.readBinary(new Uint8Array(await readFile(join(folder, `${name}.glb`))));
  await doc.transform(draco());
  const bytes = await io.writeBinary(doc);
  await writeFile(join(folder, `${name}-draco.glb`), bytes);
  return bytes;
}

/** An invisible difference: two gray levels on average, some of it from rounding at edges and texture filtering. */
function expectSame({ covered, mean, far, before, after, error }: Comparison): void {
  expect(covered).toBeGreaterThan(3000);
  expect(mean).toBeLessThan(2.5);
  expect(far).toBeLessThan(0.01);
  expect({ ...after, packedTextures: 0, names: before.names.filter((name) => after.names.includes(name)) }).toEqual({
    ...before,
    packedTextures: 0,
  });
  expect(error).toBe(0);
}

describe('a model that the export compressed', () => {
  test('is smaller, the same each time, and looks and moves the same', async () => {
    const { bytes, meshopt, ktx2 } = await compress('ball');
    expect(neededDecoders(readGltf(meshopt ?? new Uint8Array()).document)).toEqual(['meshopt']);
    expect(neededDecoders(readGltf(ktx2 ?? new Uint8Array()).document)).toEqual(['meshopt', 'ktx2']);
    expect(meshopt?.length).toBeLessThan(0.7 * bytes.length);
    expect((await compressor.compress(bytes)).ktx2).toEqual(ktx2);
    for (const form of ['meshopt', 'ktx2']) {
      for (const timeS of [0, 0.4]) {
        expectSame(await page.call<Comparison>('compare', '/models/ball.glb', `/models/ball-${form}.glb`, 'turn', timeS));
      }
    }
    const { after } = await page.call<Comparison>('compare', '/models/ball.glb', '/models/ball-ktx2.glb');
    expect(after.packedTextures).toBe(1);
  });

  test('is left alone where it was compressed already', async () => {
    const bytes = await writeDraco('ball');
    expect(await compressor.compress(bytes)).toEqual({ meshopt: null, ktx2: null });
  });

  test('is no reason to stop where it is broken', async () => {
    await expect(compressor.compress(new Uint8Array(40))).rejects.toThrow('it is neither a .glb nor a .gltf file.');
    const { meshopt } = await compress('ball');
    expect(meshopt).not.toBeNull();
  });
});

describe('a Draco model', () => {
  test('looks as it did before', async () => {
    const bytes = await writeDraco('ball');
    expect(neededDecoders(readGltf(bytes).document)).toEqual(['draco']);
    expectSame(await page.call<Comparison>('compare', '/models/ball.glb', '/models/ball-draco.glb', 'turn', 0.4));
  });

  test('is refused, and said to be damaged, where its data is', async () => {
    const bytes = await writeDraco('ball');
    const { binary } = readGltf(bytes);
    binary?.fill(0x5a);
    await writeFile(join(folder, 'broken.glb'), bytes);
    expect(await page.call('refusal', '/models/broken.glb')).toMatch(/^Error: .*(damaged|broken)/);
  });
});

test('a .gltf with files beside it looks like the same model in one', async () => {
  const io = new NodeIO();
  const doc = await io.readBinary(new Uint8Array(await readFile(join(folder, 'ball.glb'))));
  await io.write(join(folder, 'loose.gltf'), doc);
  const { mean, error } = await page.call<Comparison>('compare', '/models/ball.glb', '/models/loose.gltf', 'turn', 0.4);
  expect([mean, error]).toEqual([0, 0]);
  await rm(join(folder, 'loose.bin'), { force: true });
  await rm(join(folder, 'checks.png'), { force: true });
  expect(await page.call('refusal', '/models/loose.gltf')).toMatch(/the file ".*" that it refers to cannot be read/);
});
