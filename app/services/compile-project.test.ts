import { resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { compileProject } from './compile-project.ts';

const ROOT = resolve(import.meta.dirname, '../..');

/** Two graphs, so that a worker compiles it, with room depth as the first version of its node type saved it. */
const PROJECT = JSON.stringify({
  format: 'scrim-project',
  version: 1,
  title: 'Old',
  graphs: {
    empty: { nodes: {}, wires: [] },
    main: {
      nodes: {
        'video-a1': { type: 'source/camera-video', version: 1 },
        'depth-b2': { type: 'world/depth', version: 1 },
        'fog-c3': { type: 'filter/fog', version: 1 },
        'screen-d4': { type: 'output/screen', version: 1 },
      },
      wires: ['video-a1.layer -> fog-c3.inputImage', 'depth-b2.depth -> fog-c3.room', 'fog-c3.layer -> screen-d4.layer'],
    },
  },
});

test('a worker compiles a project of earlier versions as this thread does', async () => {
  const files = { project: PROJECT, layout: null, sources: {} };
  const here = await compileProject(ROOT, files);
  expect([here.diagnostics, here.program === null]).toEqual([[], false]);
  expect((await compileProject(ROOT, files, undefined, { root: ROOT })).program).toEqual(here.program);
});
