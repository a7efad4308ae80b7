import { describe, expect, test } from '@jest/globals';
import { plyFile, plyOf, splatAt } from '../../../tests/support/splat-files.ts';
import { sogFilesOf } from '../../../tools/examples/splats/write-sog.ts';
import { openSog } from './sog-archive.ts';
import { SOG_META } from './sog-meta.ts';
import { readSplatPly, readSplatPlyHeader } from './splat-ply.ts';
import { SplatError, splatGpuBytes } from './splats.ts';
import { readZip, unzip, writeZip } from './zip-files.ts';

const NAMES = ['x', 'y', 'z', 'f_dc_0', 'f_dc_1', 'f_dc_2', 'opacity', 'scale_0', 'scale_1', 'scale_2', 'rot_0', 'rot_1', 'rot_2', 'rot_3'];

function failure(work: () => unknown): { readonly message: string; readonly fix: string } {
  try {
    work();
  } catch (error) {
    if (error instanceof SplatError) return error;
    throw error;
  }
  throw new Error('It did not fail.');
}

describe('a PLY file', () => {
  test('tells its number of splats and the degree of its harmonics in the header', () => {
    const splat = splatAt(0, 0, 0, { harmonics: new Array(24).fill(0.1) });
    const file = plyOf([splat, splat]);
    expect(readSplatPlyHeader(file.subarray(0, 1500), file.length)).toMatchObject({ count: 2, degree: 2 });
    expect(readSplatPly(file)).toMatchObject({ count: 2, degree: 2, invalid: 0 });
  });

  test('may have comments, also about the end of its header', () => {
    const text = new TextDecoder('latin1').decode(plyFile(1, NAMES, []));
    const head = text.replace('element', 'comment vertical axis: z\ncomment then end_header\nelement');
    expect(readSplatPlyHeader(new TextEncoder().encode(head), head.length + 56)).toMatchObject({ count: 1, start: head.length });
  });

  test('that ends early is refused with the number of splats that it has', () => {
    const file = plyOf([splatAt(0, 0, 0), splatAt(1, 0, 0), splatAt(2, 0, 0)]);
    expect(failure(() => readSplatPly(file.subarray(0, file.length - 10))).message).toBe('it is incomplete: it has 2 of 3 splats');
    expect(failure(() => readSplatPly(file.subarray(0, 60))).message).toBe('its PLY header is incomplete');
  });

  test('of a mesh or of points is refused with what to do', () => {
    const faces = 'element face 1\nproperty list uchar int vertex_indices\n';
    const mesh = failure(() => readSplatPly(plyFile(1, ['x', 'y', 'z'], [0, 0, 0], faces)));
    expect(mesh).toMatchObject({
      message: 'this PLY file holds a mesh, not splats',
      fix: 'Save the mesh as .glb and import it as a model.',
    });
    const points = failure(() => readSplatPly(plyFile(1, ['x', 'y', 'z', 'red'], [0, 0, 0, 0])));
    expect(points.message).toBe('this PLY file holds points without size and rotation, not splats');
    const packed = failure(() => readSplatPly(plyFile(1, ['packed_position'], [0])));
    expect(packed).toMatchObject({ fix: 'Export it from there as PLY or as SOG.' });
  });

  test('names the properties that it lacks, and refuses other formats', () => {
    const without = NAMES.filter((name) => !['opacity', 'rot_3'].includes(name));
    expect(failure(() => readSplatPly(plyFile(1, without, new Array(without.length).fill(0)))).message).toBe('it lacks opacity, rot_3');
    const text = new TextDecoder('latin1').decode(plyFile(1, NAMES, new Array(14).fill(0)));
    const ascii = new TextEncoder().encode(text.replace('binary_little_endian', 'ascii'));
    expect(failure(() => readSplatPly(ascii))).toMatchObject({
      message: 'it is a PLY file in the format ascii',
      fix: 'Save it as binary, little endian.',
    });
    expect(failure(() => readSplatPly(plyFile(1, [...NAMES, 'f_rest_0'], new Array(15).fill(0)))).message).toContain('1 coefficients');
    expect(failure(() => readSplatPly(Uint8Array.of(1, 2)))).toMatchObject({ message: 'it is not a PLY file' });
  });

  test('without splats, with too many, or with none that is finite is refused', () => {
    expect(failure(() => readSplatPly(plyFile(0, NAMES, []))).message).toBe('it has no splats');
    expect(failure(() => readSplatPlyHeader(plyFile(5_000_000, NAMES, []), 2 ** 31)).message).toContain('at most 4000000');
    expect(failure(() => readSplatPly(plyFile(1, NAMES, new Array(14).fill(Number.NaN)))).message).toBe(
      'none of its splats has finite values',
    );
    const transparent = plyOf([splatAt(0, 0, 0, { opacity: 0.001 })]);
    expect(failure(() => readSplatPly(transparent)).message).toBe('all of its splats are transparent');
  });
});

test('half a million splats take 18 MB on the graphics card, with all harmonics 42 MB', () => {
  expect(splatGpuBytes(500_000, 0)).toBe(18_000_000);
  expect(splatGpuBytes(500_000, 3)).toBe(42_000_000);
});

describe('a SOG file', () => {
  const open = async (change: (files: Map<string, Uint8Array>) => void): Promise<string> => {
    const files = await sogFilesOf([splatAt(0, 0, 0), splatAt(1, 0, 0)]);
    change(files);
    return openSog(writeZip(files)).then(
      () => 'opened',
      (error: SplatError) => error.message,
    );
  };
  const edited = (edit: (meta: Record<string, Record<string, unknown>>) => void) =>
    open((files) => {
      const meta = JSON.parse(new TextDecoder().decode(files.get(SOG_META)));
      edit(meta);
      files.set(SOG_META, new TextEncoder().encode(JSON.stringify(meta)));
    });

  test('is opened if all of its files are there', async () => {
    expect(await open(() => {})).toBe('opened');
    expect(await open((files) => files.delete('quats.webp'))).toBe('its quats.webp is missing');
    expect(await open((files) => files.delete(SOG_META))).toBe('its meta.json is missing');
  });

  test('names only files beside its document', async () => {
    for (const name of ['../secret.webp', 'a/b.webp', '..', 'c:\\x', '']) {
      const message = await edited((meta) => Object.assign(meta.sh0 ?? {}, { files: [name] }));
      expect(message).toBe(`its "sh0" has the file ${JSON.stringify(name)}, which is not beside it`);
    }
  });

  test('has a document of version 2 with splats, limits and codebooks', async () => {
    expect(await edited((meta) => Object.assign(meta, { version: 1 }))).toBe('it is SOG version 1; only version 2 can be read');
    expect(await edited((meta) => Object.assign(meta, { count: 0 }))).toBe('it has no splats');
    expect(await edited((meta) => Object.assign(meta, { count: 1e9 }))).toContain('at most 4000000');
    expect(await edited((meta) => Object.assign(meta.scales ?? {}, { codebook: [1] }))).toBe(
      'its "scales.codebook" is not a list of 256 numbers',
    );
    expect(await edited((meta) => Object.assign(meta.means ?? {}, { mins: [0, null, 0] }))).toBe(
      'its "means.mins" is not a list of 3 numbers',
    );
    expect(await edited((meta) => Object.assign(meta, { shN: { bands: 4 } }))).toBe('its "shN.bands" is not 1, 2 or 3');
    expect(await edited((meta) => delete meta.means)).toBe('its meta.json describes no splats');
    expect(await open((files) => files.set(SOG_META, new Uint8Array()))).toBe('its meta.json is not valid JSON');
  });
});

test('an archive gives its files, stored or deflated, and a damaged one says so', async () => {
  const text = new TextEncoder().encode('abc'.repeat(100));
  const zip = writeZip(new Map([['a.txt', text]]));
  const file = readZip(zip).get('a.txt');
  expect(file && (await unzip(file))).toEqual(text);
  const deflated = new Uint8Array(
    await new Response(new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'))).arrayBuffer(),
  );
  expect(deflated.length).toBeLessThan(text.length);
  expect(await unzip({ method: 8, packed: deflated, bytes: text.length })).toEqual(text);
  await expect(unzip({ method: 8, packed: deflated.subarray(0, 5), bytes: text.length })).rejects.toThrow('its archive is damaged');
  await expect(unzip({ method: 12, packed: deflated, bytes: 1 })).rejects.toThrow('unknown method');
  expect(() => readZip(zip.subarray(0, 60))).toThrow('its archive is incomplete');
});
