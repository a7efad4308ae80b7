import { readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { loadProject } from '../../../export/graph/load.ts';
import { findLampsAtOnce } from '../../../nodes/kit/panorama/find-lamps.ts';
import { decodePanorama } from '../../../tests/support/decode-panorama.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { endGesture, undo } from '../document/apply.ts';
import { nodeOf } from '../editor/document.ts';
import { selectOnly } from '../editor/selection.ts';
import { filesOf } from '../files/files.ts';
import { currentGizmoTarget } from '../gizmo/apply-gizmo.ts';
import { editParam } from '../params/edit-params.ts';
import { directionAtPlace, directionOf, moveLamp, pinLamp, placeOf } from './edit-lamps.ts';
import { type LampView, type LampWorker, searchLamps } from './lamp-search.ts';
import { lampSourceOf } from './lamp-source.ts';
import type { LampRequest } from './messages.ts';

const EXAMPLE = resolve(import.meta.dirname, '../../../nodes/light/from-panorama/example');
const SHOTS = resolve(import.meta.dirname, '../../../nodes/source/panorama-exposures/example');
const CAPTURE = resolve(import.meta.dirname, '../../../nodes/source/panorama-capture/example');
const NODE = 'lamps-e6ts';
const SOURCE = {
  paths: ['assets/room.hdr'],
  stopsApart: 0,
  options: { method: 'solid-angle', lamps: 2, iterations: 2, intensities: 'ranks', clippedShare: 0.5 },
} as const;

async function openExample() {
  const project = loadProject({ project: await readFile(join(EXAMPLE, 'project.scrim.json'), 'utf8'), layout: null, sources: {} }).output;
  if (!project) throw new Error('The example loads.');
  const { editor, host } = await openTestEditor(project);
  const params = () => nodeOf(editor.document.getState(), NODE)?.params ?? {};
  return { editor, host, params };
}

async function exampleLamps() {
  return findLampsAtOnce(await decodePanorama(join(EXAMPLE, SOURCE.paths[0])), SOURCE.options);
}

test('a node searches the file of the Panorama at its input, with its own options', async () => {
  const { editor } = await openExample();
  expect(lampSourceOf(editor.document.getState(), NODE)).toEqual(SOURCE);
  editParam(editor, NODE, 'method', 'paper');
  editParam(editor, NODE, 'iterations', 3);
  expect(lampSourceOf(editor.document.getState(), NODE)?.options).toMatchObject({ method: 'paper', iterations: 3 });
  editParam(editor, 'room-k3wj', 'file', '');
  expect(lampSourceOf(editor.document.getState(), NODE)).toBeNull();
});

test('behind Panorama from exposures it searches all its shots', async () => {
  const text = await readFile(join(SHOTS, 'project.scrim.json'), 'utf8');
  const project = loadProject({ project: text, layout: null, sources: {} }).output;
  if (!project) throw new Error('The example loads.');
  const { editor } = await openTestEditor(project);
  const [bright, middle, dark] = ['bright', 'middle', 'dark'].map((name) => `assets/${name}.png`);
  expect(lampSourceOf(editor.document.getState(), NODE)).toMatchObject({ paths: [bright, middle, dark], stopsApart: 0 });
  editParam(editor, 'shots-q2vx', 'shots', '2');
  editParam(editor, 'shots-q2vx', 'stopsApart', 2);
  expect(lampSourceOf(editor.document.getState(), NODE)).toMatchObject({ paths: [bright, middle], stopsApart: 2 });
});

test('behind Capture panorama it searches the file that is used until a panorama is taken', async () => {
  const text = await readFile(join(CAPTURE, 'project.scrim.json'), 'utf8');
  const project = loadProject({ project: text, layout: null, sources: {} }).output;
  if (!project) throw new Error('The example loads.');
  const { editor } = await openTestEditor(project);
  expect(lampSourceOf(editor.document.getState(), 'lamps-b7qd')).toEqual(SOURCE);
});

test('places and directions are inverse; the center of the panorama is -z, its right half +x', () => {
  expect(placeOf(directionOf({ towards: [0, 0, -1] }))).toEqual({ x: 0.5, y: 0.5 });
  expect(placeOf(directionOf({ towards: [1, 0, 0] }))).toEqual({ x: 0.75, y: 0.5 });
  for (const place of [
    { x: 0.1, y: 0.3 },
    { x: 0.9, y: 0.8 },
  ]) {
    const back = placeOf(directionAtPlace(place));
    expect([back.x, back.y]).toEqual([expect.closeTo(place.x, 9), expect.closeTo(place.y, 9)]);
  }
  expect(placeOf(directionAtPlace({ x: 1.1, y: 2 }))).toEqual({ x: expect.closeTo(0.1, 9), y: 1 });
});

describe('a lamp', () => {
  test('that is dragged is pinned where it is dropped, in one undo step, as plain numbers of the project', async () => {
    const { editor, params } = await openExample();
    const before = filesOf(editor);
    moveLamp(editor, NODE, 2, { azimuthRad: 1, elevationRad: 0.5 });
    moveLamp(editor, NODE, 2, { azimuthRad: 1.23456789, elevationRad: 0.6 });
    endGesture(editor);
    const stored = { lamp2Pinned: { value: true }, lamp2AzimuthRad: { value: 1.2346 }, lamp2ElevationRad: { value: 0.6 } };
    expect(params()).toMatchObject(stored);
    expect(JSON.parse(filesOf(editor).project).graphs.main.nodes[NODE].params).toMatchObject({ lamp2AzimuthRad: 1.2346 });
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('is pinned where it was found, and let go; pinned, the gizmo of the preview rotates it', async () => {
    const { editor, params } = await openExample();
    selectOnly(editor.selection, [NODE]);
    expect(currentGizmoTarget(editor, 'rotate')).toMatchObject({ target: null, reason: expect.stringMatching(/^Lamp 1 is not pinned/) });
    const found = await exampleLamps();
    pinLamp(editor, NODE, 1, found, true);
    const [x = 0, y = 0, z = 0] = found.lamps[0]?.towards ?? [];
    expect(params()).toMatchObject({
      lamp1AzimuthRad: { value: expect.closeTo(Math.atan2(x, z), 4) },
      lamp1ElevationRad: { value: expect.closeTo(Math.asin(y), 4) },
    });
    expect(currentGizmoTarget(editor, 'rotate').target).toMatchObject({
      program: NODE,
      handles: { azimuth: 'lamp1AzimuthRad', elevation: 'lamp1ElevationRad' },
    });
    editor.gizmo.setState({ lamp: 2 });
    expect(currentGizmoTarget(editor, 'rotate').target).toBeNull();
    pinLamp(editor, NODE, 1, found, false);
    expect(params()).not.toHaveProperty('lamp1Pinned');
    undo(editor);
    expect(params()).toMatchObject({ lamp1Pinned: { value: true } });
  });
});

describe('a search', () => {
  async function start() {
    const { editor, host } = await openExample();
    const file = await readFile(join(EXAMPLE, SOURCE.paths[0]));
    host.answer('asset.read', async () => ({ base64: file.toString('base64') }));
    const views: LampView[] = [];
    const log: unknown[] = [];
    let give: (worker: LampWorker) => void = () => {};
    const started = new Promise<LampWorker>((resolve) => {
      give = resolve;
    });
    const createWorker = (): LampWorker => {
      const worker: LampWorker = {
        postMessage: ({ files, options }: LampRequest) => {
          log.push(files[0]?.byteLength, options.lamps);
          give(worker);
        },
        onmessage: null,
        onerror: null,
        terminate: () => log.push('terminate'),
      };
      return worker;
    };
    const cancel = searchLamps(editor, SOURCE, createWorker, (view) => views.push(view));
    const worker = await started;
    const answer = (data: unknown) => worker.onmessage?.({ data } as never);
    return { views, log, cancel, answer, size: file.length };
  }

  test('gets the file, tells its progress and shows its result; then its worker ends', async () => {
    const { views, log, cancel, answer, size } = await start();
    const closed: string[] = [];
    answer({ kind: 'part', part: 0.5 });
    answer({ kind: 'found', found: await exampleLamps(), stages: [{ image: { close: () => closed.push('closed') } }] });
    expect(views.map((view) => (view.state === 'searching' ? view.part : view.state))).toEqual([0, 0.5, 'found']);
    expect(log).toEqual([size, 2, 'terminate']);
    cancel();
    expect(closed).toEqual(['closed']);
  });

  test('that is canceled ends its worker; a file that cannot be read is named', async () => {
    const canceled = await start();
    canceled.cancel();
    expect([canceled.log.at(-1), canceled.views.length]).toEqual(['terminate', 1]);
    const { views, answer } = await start();
    answer({ kind: 'failed', reason: 'the file is damaged (it ends too early). Export it again' });
    expect(views.at(-1)).toEqual({
      state: 'failed',
      reason: 'assets/room.hdr cannot be searched: the file is damaged (it ends too early). Export it again.',
    });
  });
});
