import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { createCompiler } from '../../export/compiler/compile.ts';
import { describeProgram } from '../../export/compiler/describe.ts';
import { totalBytes } from '../../export/compiler/target-bytes.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { Project } from '../../export/graph/project.ts';
import type { DrawOperation, PassOperation, Program } from '../../export/program/program.ts';
import { formatDiagnostic } from '../../nodes/kit/diagnostics.ts';
import { surround } from '../../tools/new-node/surround.ts';
import { LIBRARY } from '../support/library.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';
import { TESTS_FOLDER } from '../support/this-test.ts';
import { AR_WIRES } from './graphs.ts';
import { programFaults } from './program-faults.ts';

const ROOT = join(TESTS_FOLDER, '..');
const { compile: again } = createCompiler();

function program(project: Project): Program {
  const { output, diagnostics } = again({ project, library: LIBRARY });
  if (output === null) throw new Error(diagnostics.map(formatDiagnostic).join('\n'));
  return output;
}

async function exampleFolders(): Promise<string[]> {
  const found = await readdir(join(ROOT, 'nodes'), { recursive: true });
  const ofNodes = found.filter((path) => path.endsWith('example/project.scrim.json')).map((path) => `nodes/${path}`);
  const shipped = (await readdir(join(ROOT, 'examples'))).map((name) => `examples/${name}/project.scrim.json`);
  return [...ofNodes, ...shipped, 'examples/boards/gallery/project.scrim.json']
    .map((path) => path.slice(0, -'/project.scrim.json'.length))
    .sort();
}

async function readProject(folder: string): Promise<Project | null> {
  const text = (name: string) => readFile(join(ROOT, folder, name), 'utf8').catch(() => null);
  const project = await text('project.scrim.json');
  if (project === null) return null;
  const { output, diagnostics } = loadProject({ project, layout: await text('project.layout.json'), sources: {} });
  expect(diagnostics).toEqual([]);
  return output;
}

describe('the library that ships', () => {
  test.each([...LIBRARY.types()])('%s compiles in the smallest project that shows it', (type) => {
    const made = program(surround(LIBRARY, type, type));
    expect(programFaults(made)).toEqual([]);
    expect(describeProgram(made)).toContain(type === 'source/camera-video' ? 'the world' : 'Per view');
  });

  test('its examples compile without a word but about files, and fusion never needs more memory', async () => {
    const folders = await exampleFolders();
    expect(folders.length).toBeGreaterThan(10);
    for (const folder of folders) {
      const project = await readProject(folder);
      if (!project) continue;
      const { output, diagnostics } = again({ project, library: LIBRARY });
      expect([folder, diagnostics.map(formatDiagnostic)]).toEqual([folder, []]);
      expect(output && programFaults(output)).toEqual([]);
      const fused = again({ project, library: LIBRARY, options: { fuse: true } }).output;
      if (output === null || fused === null) throw new Error(`${folder} does not compile.`);
      expect(programFaults(fused)).toEqual([]);
      expect([folder, totalBytes(fused)]).toEqual([folder, Math.min(totalBytes(fused), totalBytes(output))]);
    }
  });
});

/** A model before and behind the room, its shadow on the floor, over the camera video. */
function firstLight(): TestStudio {
  return new TestStudio({ library: LIBRARY, readShader })
    .add('video-a', 'source/camera-video')
    .add('fox-a', 'objects/primitive')
    .add('place-a', 'objects/transform')
    .add('floor-a', 'objects/phantom')
    .add('box-a', 'objects/primitive')
    .add('sun-a', 'light/directional')
    .add('room-a', 'world/depth')
    .add('scene-a', 'layer/scene')
    .add('hide-a', 'layer/depth-occlusion')
    .add('shadow-a', 'layer/shadow')
    .add('over-a', 'operator/over')
    .add('over-b', 'operator/over')
    .add('screen-a', 'output/screen')
    .wire(...AR_WIRES);
}

describe('first light', () => {
  test('draws forward, asks for depth and nothing else, and shares one set of shadow maps', () => {
    const made = program(firstLight().project);
    expect(made.presentation).toMatchObject({ mode: 'forward', background: 'world', antialias: true });
    expect(made.needs.map(({ capability }) => capability)).toEqual(['depth']);
    expect(made.operations.filter(({ kind }) => kind === 'shadow-maps')).toHaveLength(1);
    const draws = made.operations.filter((operation): operation is DrawOperation => operation.kind === 'draw');
    expect(draws.map(({ id, target, occlusion }) => [id, target, occlusion?.node ?? null])).toEqual([
      ['shadow-a', 'screen', null],
      ['scene-a', 'screen', 'hide-a'],
    ]);
    expect(made.shaders).toEqual([]);
  });

  test('styled as a whole it is composed, and asks for the camera', () => {
    const studio = firstLight()
      .add('sepia-a', 'filter/sepia')
      .wire('over-b.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer');
    const made = program(studio.project);
    expect(made.presentation.mode).toBe('composed');
    expect(made.needs.map(({ capability }) => capability)).toEqual(['camera-image', 'depth']);
    const passes = made.operations.filter((operation): operation is PassOperation => operation.kind === 'pass');
    expect(passes.map(({ id, target }) => [id, target])).toEqual([
      ['over-a.pass0', 'over-a.layer'],
      ['over-b.pass0', 'over-b.layer'],
      ['sepia-a.pass0', 'screen'],
    ]);
  });

  test('everything that the inspector may set while it runs has a slot', () => {
    const studio = firstLight()
      .add('sepia-a', 'filter/sepia')
      .wire('over-b.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer');
    const { slots } = program(studio.project);
    for (const [id, { type }] of Object.entries(studio.project.graphs.main?.nodes ?? {})) {
      const params = Object.entries(LIBRARY.definition(type)?.params ?? {}).filter(([, { stage }]) => stage === 'uniform');
      for (const [name] of params) expect(Object.keys(slots.params)).toContain(`${id}.${name}`);
    }
  });
});

test('filters by distance ask for a layer with depth, or for the room', () => {
  const studio = new TestStudio({ library: LIBRARY, readShader })
    .add('video-a', 'source/camera-video')
    .add('fog-a', 'filter/fog')
    .add('screen-a', 'output/screen')
    .wire('video-a.layer -> fog-a.inputImage', 'fog-a.layer -> screen-a.layer');
  const warnings = ({ project }: TestStudio) => again({ project, library: LIBRARY }).diagnostics.map(({ code, port }) => [code, port]);
  expect(warnings(studio)).toEqual([['SCR043', 'inputImage']]);
  expect(warnings(studio.add('room-a', 'world/depth').wire('room-a.depth -> fog-a.room'))).toEqual([]);
});

test('sound is played although no picture depends on it, once something is connected to it', () => {
  const studio = firstLight().add('tap-a', 'input/tap').add('sound-a', 'output/sound');
  const nodes = ({ project }: TestStudio) => program(project).operations.map(({ id }) => id);
  expect(nodes(studio)).not.toEqual(expect.arrayContaining(['tap-a']));
  expect(nodes(studio.wire('tap-a.tapped -> sound-a.play'))).toEqual(expect.arrayContaining(['tap-a', 'sound-a']));
});

test('bodies that reach two physics worlds are an error at the second', () => {
  const studio = firstLight()
    .add('body-a', 'physics/body')
    .add('world-a', 'physics/world')
    .wire('fox-a.objects -> body-a.objects', 'body-a.objects -> scene-a.objects', 'body-a.body -> world-a.bodies');
  const errors = ({ project }: TestStudio) => again({ project, library: LIBRARY }).diagnostics.map(({ code, nodeId }) => [code, nodeId]);
  expect(errors(studio)).toEqual([]);
  expect(errors(studio.add('world-b', 'physics/world').wire('body-a.body -> world-b.bodies'))).toEqual([['SCR027', 'world-b']]);
});
