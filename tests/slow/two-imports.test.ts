import { type ChildProcess, spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { encode } from 'jpeg-js';
import { colmapModel, HEIGHT_PX, WIDTH_PX } from '../support/colmap-model.ts';
import { writeProgram } from '../support/fake-program.ts';
import { eventually } from '../support/patience.ts';
import { projectText, writeProject } from '../support/project-kit.ts';

/* Two processes that reconstruct or import the same folder. Programs that wait for a file stand in for COLMAP and Blender. */

const SCRIM = resolve(import.meta.dirname, '../../bin/scrim.mjs');
const NAMES = ['a.jpg', 'b.jpg', 'c.jpg'];
const PLY =
  'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 2\n1 0 2\n0 1 2\n3 0 1 2\n';
/** Waits until the test lets programs go on. */
const WAIT = (go: string) =>
  `while (!fs.existsSync(${JSON.stringify(go)})) Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 20);`;

let base = '';
let scan = '';
let go = '';
const children = new Set<ChildProcess>();
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-two-'));
  [scan, go] = [join(base, 'scan'), join(base, 'go')];
  await mkdir(join(scan, 'images'), { recursive: true });
  const photo = encode({ width: WIDTH_PX, height: HEIGHT_PX, data: new Uint8Array(WIDTH_PX * HEIGHT_PX * 4).fill(90) }, 90).data;
  for (const name of NAMES) await writeFile(join(scan, 'images', name), photo);
  await mkdir(join(base, 'model'));
  for (const [name, bytes] of Object.entries(colmapModel(NAMES))) await writeFile(join(base, 'model', `${name}.bin`), bytes);
});
afterEach(async () => {
  await writeFile(go, '');
  for (const child of children) child.kill('SIGKILL');
  children.clear();
  await rm(base, { recursive: true, force: true, maxRetries: 5 });
});

function scrim(...args: string[]) {
  const { NODE_OPTIONS: _, ...env } = process.env;
  const child = spawn(process.execPath, [SCRIM, ...args], { env, stdio: ['ignore', 'pipe', 'pipe'] });
  children.add(child);
  const said: string[] = [];
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (chunk) => said.push(String(chunk)));
  return { child, pid: child.pid ?? 0, end: once(child, 'exit').then(([status]) => ({ status, said: said.join('') })) };
}

async function appears(folder: string, name: string): Promise<void> {
  while (!(await readdir(folder)).includes(name)) await new Promise((done) => setTimeout(done, 20));
}

test('one process reconstructs a folder at a time, until it ends or is killed', async () => {
  const { path: colmap } = await writeProgram(
    join(base, 'bin/colmap'),
    `const option = (name) => args[args.indexOf(name) + 1];
     if (args[0] === 'help') { console.log('COLMAP 3.12.1 -- Structure-from-Motion (without CUDA)'); process.exit(0); }
     if (args[0] === 'feature_extractor') { fs.writeFileSync(${JSON.stringify(join(base, 'begun'))}, String(process.pid)); ${WAIT(go)} }
     if (args[0] === 'mapper') fs.cpSync(${JSON.stringify(join(base, 'model'))}, path.join(option('--output_path'), '0'), { recursive: true });
     if (args[0] === 'poisson_mesher') fs.writeFileSync(option('--output_path'), ${JSON.stringify(PLY)});`,
  );
  const reconstruct = () => scrim('reconstruct', scan, '--colmap', colmap);
  const first = reconstruct();
  await appears(base, 'begun');
  const second = await reconstruct().end;
  expect(second.status).toBe(1);
  expect(second.said).toContain(`SCR066: Another Scrim (process ${first.pid}) is finding the cameras of ${scan}.`);

  // It cannot remove its lock.
  first.child.kill('SIGKILL');
  await first.end;
  expect(await readdir(scan)).toContain('.scrim-reconstruction.lock');
  // Its COLMAP does not write beside the next one.
  const left = Number(await readFile(join(base, 'begun'), 'utf8'));
  await eventually(() => expect(() => process.kill(left, 0)).toThrow('ESRCH'));
  await writeFile(go, '');
  const third = await reconstruct().end;
  expect([third.status, third.said]).toEqual([0, expect.stringContaining('3 of 3 photographs')]);
  expect((await readdir(scan)).sort()).toEqual(['.scrim-reconstruction', 'images', 'sparse']);
});

test('one process imports a folder into a project at a time', async () => {
  const project = join(base, 'project');
  await writeProject(project, { 'project.scrim.json': projectText({ nodes: { 'screen-a1': 'output/screen' }, wires: [] }) });
  await mkdir(join(scan, 'sparse/0'), { recursive: true });
  for (const [name, bytes] of Object.entries(colmapModel(NAMES))) await writeFile(join(scan, 'sparse/0', `${name}.bin`), bytes);
  await writeFile(join(scan, 'mesh.ply'), PLY);
  const { path: simplifier } = await writeProgram(
    join(base, 'bin/Instant Meshes'),
    `fs.writeFileSync(${JSON.stringify(join(base, 'begun'))}, ''); ${WAIT(go)} fs.writeFileSync(args[args.indexOf('-o') + 1], ${JSON.stringify(PLY)});`,
  );
  const simple = ['--triangles', '4', '--program', 'instant-meshes', '--path', simplifier];
  const add = () => scrim('import', 'capture', scan, '--project', project, ...simple);
  const first = add();
  await appears(base, 'begun');
  const second = await add().end;
  expect(second.status).toBe(1);
  expect(second.said).toContain(`SCR066: Another Scrim (process ${first.pid}) is importing the capture scan into ${project}.`);
  await writeFile(go, '');
  expect(await first.end).toMatchObject({ status: 0 });
  expect(await readdir(join(project, 'assets'))).toEqual(['scan.capture']);
  expect(await add().end).toMatchObject({ status: 0 });
  expect((await readdir(join(project, 'assets'))).sort()).toEqual(['scan-2.capture', 'scan.capture']);
});
