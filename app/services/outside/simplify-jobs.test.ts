import { cp, mkdir, mkdtemp, readdir, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { NodeIO } from '@gltf-transform/core';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { meshAsGlb } from '../../../export/captures/write-glb.ts';
import { meshAsPly } from '../../../export/captures/write-ply.ts';
import { type CaptureMesh, readCapture, readCaptureMesh } from '../../../nodes/kit/capture.ts';
import { writeProgram } from '../../../tests/support/fake-program.ts';
import { openWindow, startHost, stopHosts } from '../../../tests/support/host-kit.ts';
import type { HostEvent, HostInput } from '../../contract/contract.ts';

/* The calls of the editor, with a program that stands in for Instant Meshes. tests/slow/editor-simplify.test.ts runs the real Blender. */

let base = '';
let project = '';
const BALL = 'nodes/source/capture-mesh/example/assets/glossy-ball.capture';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-simplify-jobs-'));
  project = join(base, 'project');
  await mkdir(join(project, 'assets'), { recursive: true });
  await writeFile(join(project, 'project.scrim.json'), '{"title":"First"}\n');
  await writeFile(join(project, 'assets/grid.glb'), meshAsGlb(grid(8)));
});
afterEach(async () => {
  await stopHosts();
  await rm(base, { recursive: true, force: true });
});

/** A square of side 1 with `side` by `side` cells. */
function grid(side: number): CaptureMesh {
  const at = (i: number, j: number) => i * (side + 1) + j;
  const lines = Array.from({ length: side + 1 }, (_, i) => i);
  const cells = lines.slice(1).flatMap((i) => lines.slice(1).map((j) => [i - 1, j - 1] as const));
  return {
    positions: Float32Array.from(lines.flatMap((i) => lines.flatMap((j) => [i / side, 0, j / side]))),
    indices: Uint32Array.from(
      cells.flatMap(([i, j]) => [at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)]),
    ),
  };
}

const HELP = "if (args[0] === '--help') { console.log('Syntax: x [options] <input mesh / point cloud>'); process.exit(255); }";

/** A program that prints, and writes this mesh. */
async function fakeProgram(mesh: CaptureMesh, before = '') {
  const file = join(base, 'result.ply');
  await writeFile(file, meshAsPly(mesh));
  return writeProgram(
    join(base, 'bin/Instant Meshes'),
    `${HELP} console.log('Setting up 64 faces'); ${before} fs.copyFileSync(${JSON.stringify(file)}, args[args.indexOf('-o') + 1]);`,
  );
}

async function open() {
  const host = startHost();
  const events: HostEvent[] = [];
  host.subscribe((event) => events.push(event));
  const { call } = openWindow(host, 'a');
  const { handle } = await call('project.open', { path: project });
  return { call, handle, events };
}

type Asked = Omit<HostInput<'simplify.run'>, 'handle'>;
const asked = (executable: string | null, more: Partial<Asked> = {}): Asked => ({
  ...{ path: 'assets/grid.glb', program: 'instant-meshes', executable, triangles: 30 },
  ...more,
});

test('a model becomes another model of fewer triangles, beside the one before', async () => {
  const before = await readFile(join(project, 'assets/grid.glb'));
  const { path: executable } = await fakeProgram(grid(3));
  const { call, handle, events } = await open();
  expect(await call('simplify.look', { handle, path: 'assets/grid.glb', program: 'instant-meshes', executable })).toEqual({
    ...{ triangles: 128, tool: `(${executable})`, diagnostic: null },
  });
  const done = await call('simplify.run', { handle, ...asked(executable) });
  expect(done).toEqual({ path: 'assets/grid-simple.glb', before: 128, after: 18 });
  expect(await readFile(join(project, 'assets/grid.glb'))).toEqual(before);
  const document = await new NodeIO().read(join(project, 'assets/grid-simple.glb'));
  const [primitive] = document.getRoot().listMeshes()[0]?.listPrimitives() ?? [];
  expect(primitive?.getIndices()?.getCount()).toBe(54);
  const steps = events.flatMap((event) => (event.kind === 'tool-progress' ? event.step : []));
  expect([...new Set(steps)]).toEqual(['read', 'simplify', 'write']);
  expect(events.flatMap((event) => (event.kind === 'tool-log' ? event.lines : []))).toContain('Setting up 64 faces');
  // A simple model of another size has another name.
  await fakeProgram(grid(2));
  const again = await call('simplify.run', { handle, ...asked(executable, { path: 'assets/grid-simple.glb' }) });
  expect(again).toMatchObject({ path: 'assets/grid-simple-2.glb', after: 8 });
});

test('a capture becomes a copy with the same photographs and a simpler mesh', async () => {
  const ball = join(project, 'assets/ball.capture');
  await cp(BALL, ball, { recursive: true });
  const document = readCapture(await readFile(join(ball, 'capture.json'), 'utf8'));
  const mesh = readCaptureMesh(document.mesh, Uint8Array.from(await readFile(join(ball, document.mesh.file))).buffer);
  // All vertices, so that it is where it was, but only half of the triangles.
  const half = { positions: mesh.positions, indices: mesh.indices.slice(0, 3 * Math.floor(mesh.indices.length / 6)) };
  const { path: executable } = await fakeProgram(half);
  const { call, handle } = await open();
  const done = await call('simplify.run', { handle, ...asked(executable, { path: 'assets/ball.capture/capture.json', triangles: 1000 }) });
  expect(done).toEqual({
    path: 'assets/ball-simple.capture/capture.json',
    before: document.mesh.triangleCount,
    after: Math.floor(document.mesh.triangleCount / 2),
  });
  const copy = join(project, 'assets/ball-simple.capture');
  const simple = readCapture(await readFile(join(copy, 'capture.json'), 'utf8'));
  expect(simple.views).toEqual(document.views);
  for (const { file } of simple.views) expect(await readFile(join(copy, file))).toEqual(await readFile(join(ball, file)));
  expect(readCaptureMesh(simple.mesh, Uint8Array.from(await readFile(join(copy, simple.mesh.file))).buffer).indices).toEqual(half.indices);
  expect(readCapture(await readFile(join(ball, 'capture.json'), 'utf8'))).toEqual(document);
});

test('only assets are read, and only the program itself is run', async () => {
  const { path: executable } = await fakeProgram(grid(3));
  await writeFile(join(base, 'secret.glb'), meshAsGlb(grid(2)));
  await symlink(join(base, 'secret.glb'), join(project, 'assets/link.glb'));
  await writeFile(join(project, 'other.glb'), meshAsGlb(grid(2)));
  const { call, handle } = await open();
  for (const path of ['assets/../../secret.glb', 'assets/link.glb', 'other.glb', '/etc/passwd']) {
    const run = call('simplify.run', { handle, ...asked(executable, { path }) });
    await expect(run).rejects.toMatchObject({ diagnostic: { code: 'SCR031' } });
  }
  for (const [name, script] of [
    ['bin/sh', ''],
    ['bin/instant-meshes', "console.log('GNU other 1.0')"],
  ] as const) {
    const other = await writeProgram(join(base, name), script);
    const run = call('simplify.run', { handle, ...asked(other.path) });
    const message = expect.stringContaining(`${other.path} is not Instant Meshes`);
    await expect(run).rejects.toMatchObject({ diagnostic: { code: 'SCR078', message } });
    expect(
      await call('simplify.look', { handle, path: 'assets/grid.glb', program: 'instant-meshes', executable: other.path }),
    ).toMatchObject({
      ...{ triangles: 128, tool: null, diagnostic: { message, fix: expect.stringContaining('https://github.com/wjakob/instant-meshes') } },
    });
  }
  expect((await readdir(join(project, 'assets'))).sort()).toEqual(['grid.glb', 'link.glb']);
});

test('canceled, also by another run of the project, it leaves nothing', async () => {
  const begun = join(base, 'begun');
  const { path: executable } = await fakeProgram(
    grid(3),
    `fs.writeFileSync(${JSON.stringify(begun)}, ''); setInterval(() => {}, 1000); return;`,
  );
  const { call, handle } = await open();
  /** Resolves when the program runs, to its result. */
  const begin = async () => {
    await rm(begun, { force: true });
    const result = call('simplify.run', { handle, ...asked(executable) });
    while (!(await readdir(base)).includes('begun')) await new Promise((done) => setTimeout(done, 10));
    return { result };
  };
  const canceled = { path: null, before: 0, after: 0 };
  const first = await begin();
  const second = await begin();
  expect(await first.result).toEqual(canceled);
  await call('tool.cancel', { handle });
  expect(await second.result).toEqual(canceled);
  expect(await readdir(join(project, 'assets'))).toEqual(['grid.glb']);
});
