import { spawnSync } from 'node:child_process';
import { cp, mkdir, mkdtemp, readdir, readFile, rename, rm, stat, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { colmapModel } from '../../../tests/support/colmap-model.ts';
import { type FakeProgram, writeProgram } from '../../../tests/support/fake-program.ts';
import { type ReconstructionJob, reconstruct } from './reconstruct-photographs.ts';

/*
 * What COLMAP does where it is not the one of this machine: with CUDA, without a graphics card, killed, of other options. A program stands
 * in for it that takes its arguments and writes its files; tests/slow/reconstruct.test.ts runs the real one.
 */

const NAMES = ['-a b.jpg', 'ö.JPG', '"c".png'];
let base = '';
let folder = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-fake-colmap-'));
  folder = join(base, 'my scan');
  await mkdir(join(folder, 'images'), { recursive: true });
  for (const name of NAMES) await writeFile(join(folder, 'images', name), 'a photograph');
  const model = colmapModel([...NAMES].sort());
  await mkdir(join(base, 'model'));
  for (const [name, bytes] of Object.entries(model)) await writeFile(join(base, 'model', `${name}.bin`), bytes);
});
afterEach(() => rm(base, { recursive: true, force: true }));

const PLY =
  'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 2\n1 0 2\n0 1 2\n3 0 1 2\n';

/** @param acts Scripts that run before what the commands do. */
function fakeColmap(acts: Readonly<Record<string, string>> = {}, built = 'without CUDA'): Promise<FakeProgram> {
  return writeProgram(
    join(base, 'bin/colmap'),
    `const option = (name) => args[args.indexOf(name) + 1];
     const [command, second] = args;
     if (command === 'help') { console.log('COLMAP 3.12.1 -- Structure-from-Motion and Multi-View Stereo\\n  (Commit x ${built})'); process.exit(0); }
     if (second === '-h') { console.log('--FeatureExtraction.use_gpu arg\\n--FeatureMatching.use_gpu arg'); process.exit(0); }
     const acts = ${JSON.stringify(acts)};
     if (acts[command]) eval(acts[command]);
     if (command === 'feature_extractor') for (let i = 1; i <= 3; i++) console.log('Processed file [' + i + '/3]');
     if (command === 'mapper') fs.cpSync(${JSON.stringify(join(base, 'model'))}, path.join(option('--output_path'), '0'), { recursive: true });
     if (command === 'image_undistorter') fs.cpSync(${JSON.stringify(join(base, 'model'))}, option('--output_path'), { recursive: true });
     if (command === 'poisson_mesher') fs.writeFileSync(option('--output_path'), ${JSON.stringify(PLY)});`,
  );
}

const run = (colmap: FakeProgram, more: Partial<ReconstructionJob> = {}) =>
  reconstruct({
    folder,
    colmap: colmap.path,
    oneCamera: true,
    dense: null,
    say: () => {},
    interrupted: new AbortController().signal,
    ...more,
  });

/** Commands that were called, without questions about options. */
const commandsOf = async (colmap: FakeProgram) =>
  (await colmap.calls()).flatMap(([name = '', second]) => (name === 'help' || second === '-h' ? [] : [name]));

const FAIL = (text: string) => `console.error(${JSON.stringify(text)}); process.exit(1);`;

test('without CUDA, the points that photographs share become a mesh', async () => {
  const colmap = await fakeColmap();
  const said: string[] = [];
  const result = await run(colmap, { say: (text, step) => said.push(`${step}: ${text}`) });
  expect(result).toMatchObject({ photographs: 3, found: 3, mesh: 'sparse/0/mesh.ply', isDense: false, diagnostics: [] });
  expect(said).toEqual(expect.arrayContaining(['features: Finding features (2 of 3)…', 'mesh: Making a mesh…']));
  const calls = await colmap.calls();
  const extract = calls.find(([name, second]) => name === 'feature_extractor' && second !== '-h') ?? [];
  // COLMAP 3.12 renamed the groups of options.
  expect(extract.slice(-2)).toEqual(['--FeatureExtraction.use_gpu', '0']);
  expect((await readFile(join(folder, '.scrim-reconstruction/photographs.txt'), 'utf8')).split('\n')).toEqual([...[...NAMES].sort(), '']);
  // The points that the mesher got have normals.
  const points = await readFile(join(folder, '.scrim-reconstruction/points.ply'), 'latin1');
  expect(points).toContain('element vertex 144\n');
  expect((await run(colmap)).kept).toEqual(['features', 'matches', 'sparse', 'mesh']);
});

test('with CUDA, depth becomes the mesh', async () => {
  const colmap = await fakeColmap({}, 'with CUDA');
  expect(await run(colmap)).toMatchObject({ mesh: 'dense/0/meshed-poisson.ply', isDense: true });
  expect(await commandsOf(colmap)).toEqual([
    ...['feature_extractor', 'exhaustive_matcher', 'mapper', 'image_undistorter', 'patch_match_stereo', 'stereo_fusion', 'poisson_mesher'],
  ]);
  expect(await readdir(join(folder, 'dense/0'))).toContain('meshed-poisson.ply');
});

test('with CUDA but no graphics card, it goes on without, and says why the mesh is rough', async () => {
  const noCard = 'CUDA error: no CUDA-capable device is detected';
  const failOnGpu = `if (args.at(-1) === '1') { ${FAIL(noCard)} }`;
  const colmap = await fakeColmap({ feature_extractor: failOnGpu, patch_match_stereo: FAIL(noCard) }, 'with CUDA');
  const result = await run(colmap);
  expect(result).toMatchObject({ mesh: 'sparse/0/mesh.ply', isDense: false });
  const gpu = (await colmap.calls())
    .filter(([, second]) => second !== '-h')
    .flatMap((call) => (/use_gpu/.test(call.at(-2) ?? '') ? [call.at(-1)] : []));
  // Once with, then without for all.
  expect(gpu).toEqual(['1', '0', '0']);
  // A card that extraction cannot use has no depth either.
  expect(await commandsOf(colmap)).not.toContain('patch_match_stereo');
});

test('depth that fails is a warning, or an error where it was asked for', async () => {
  const colmap = await fakeColmap({ patch_match_stereo: FAIL('CUDA driver version is insufficient') }, 'with CUDA');
  await expect(run(colmap, { dense: true })).rejects.toMatchObject({
    diagnostic: { code: 'SCR078', message: expect.stringContaining('driver version') },
  });
  const { diagnostics, mesh } = await run(colmap);
  expect(diagnostics).toEqual([expect.objectContaining({ severity: 'warning', message: expect.stringContaining('driver version') })]);
  expect(mesh).toBe('sparse/0/mesh.ply');
  const without = await fakeColmap();
  await expect(run(without, { dense: true })).rejects.toMatchObject({ diagnostic: { message: expect.stringContaining('without CUDA') } });
});

test('a COLMAP that is killed is named with the likely reason; the next call continues', async () => {
  const killed = await fakeColmap({ exhaustive_matcher: "process.kill(process.pid, 'SIGKILL')" });
  await expect(run(killed)).rejects.toMatchObject({
    diagnostic: {
      code: 'SCR078',
      message: expect.stringContaining('exhaustive_matcher ended by SIGKILL'),
      fix: expect.stringMatching(/memory.*colmap\.log/),
    },
  });
  const colmap = await fakeColmap();
  expect(await run(colmap)).toMatchObject({ kept: ['features'], found: 3 });
});

test('another program is not run for its commands', async () => {
  const other = await writeProgram(join(base, 'bin/other'), "console.log('GNU other 1.0')");
  await expect(run(other)).rejects.toMatchObject({ diagnostic: { code: 'SCR078', message: `${other.path} is not COLMAP.` } });
  expect(await other.calls()).toEqual([['help']]);
  expect(await readdir(folder)).toEqual(['images']);
});

test('pipes and folders among the photographs are left out, and a folder that goes away is named', async () => {
  expect(spawnSync('mkfifo', [join(folder, 'images/pipe.jpg')]).status).toBe(0);
  await mkdir(join(folder, 'images/folder.png'));
  const gone = await fakeColmap({ exhaustive_matcher: `fs.renameSync(${JSON.stringify(folder)}, ${JSON.stringify(join(base, 'moved'))})` });
  await expect(run(gone)).rejects.toMatchObject({ diagnostic: { code: 'SCR004', message: expect.stringContaining(`${folder} is gone`) } });
  await rename(join(base, 'moved'), folder);
  expect((await run(await fakeColmap())).photographs).toBe(3);
});

test('another window of the same process is refused', async () => {
  const colmap = await fakeColmap();
  const both = await Promise.allSettled([run(colmap), run(colmap)]);
  expect(both.filter(({ status }) => status === 'fulfilled')).toHaveLength(1);
  expect(both.find(({ status }) => status === 'rejected')).toMatchObject({
    reason: { diagnostic: { code: 'SCR066', message: `Another window of this Scrim is finding the cameras of ${folder}.` } },
  });
  expect((await run(colmap)).kept).toEqual(['features', 'matches', 'sparse', 'mesh']);
});

test('what was found stays as it is if the disk is full', async () => {
  const colmap = await fakeColmap();
  await run(colmap);
  const before = await stat(join(folder, 'sparse/0/images.bin'));
  await cp(join(folder, 'images', NAMES[0] ?? ''), join(folder, 'images/d.jpg'));
  const full = await fakeColmap({ mapper: FAIL('database or disk is full') });
  await expect(run(full)).rejects.toMatchObject({ diagnostic: { message: expect.stringContaining('database or disk is full') } });
  expect((await stat(join(folder, 'sparse/0/images.bin'))).mtimeMs).toBe(before.mtimeMs);
});
