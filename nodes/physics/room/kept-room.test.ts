import { expect, test } from '@jest/globals';
import { Matrix4 } from 'three';
import { createKeptFiles } from '../../../export/runtime/spatial/kept-files.ts';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { Anchor } from '../../kit/anchors.ts';
import { emptyVoxels, writeVoxelFile } from '../../kit/voxel-file.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const FILE = writeVoxelFile(emptyVoxels(0.05, 3));
const IMAGE = {
  meters: new Float32Array(4).fill(1),
  widthPx: 2,
  heightPx: 2,
  frame: 0,
  uvFromViewUv: Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1),
  clipFromView: Float32Array.from(new Matrix4().makePerspective(-0.1, 0.1, 0.1, -0.1, 0.1, 100).elements),
  worldFromView: Float32Array.from(new Matrix4().makeTranslation(2, 1.6, 3).elements),
};

/** A browser in which visits of a page follow each other, on a device that keeps anchors or not. */
function device({ keeps = true, page = '/room/' } = {}) {
  const stored = new Map<string, string>();
  const storage = {
    getItem: (key: string) => stored.get(key) ?? null,
    setItem: (key: string, value: string) => void stored.set(key, value),
    removeItem: (key: string) => void stored.delete(key),
  };
  const places = new Set<string>();
  const visit = (params: Record<string, number | boolean> = {}, worldFromPlace = new Matrix4()) => {
    const image = { ...IMAGE };
    const anchorAt = (matrix: ArrayLike<number>, state: Anchor['state'], keeping: Anchor['keeping']) => {
      const worldFromAnchor = Float32Array.from(matrix);
      return { id: 'a', state, keeping, worldFromAnchor, evicted: 0, delete: () => {} };
    };
    let restored: ReturnType<typeof anchorAt> | null = null;
    const anchors = {
      create: (at: ArrayLike<number>, name: string) => {
        if (keeps) places.add(name);
        return anchorAt(at, 'tracked', keeps ? 'kept' : 'refused');
      },
      restore: (name: string) => {
        restored = places.has(name) ? anchorAt(worldFromPlace.elements, 'pending', 'kept') : null;
        return restored;
      },
      forget: (name: string) => void places.delete(name),
    };
    const clear = createPulseQueue();
    const session = {
      sessions: 0,
      depthImage: () => image,
      anchors,
      answerRays: () => () => {},
      keptFiles: createKeptFiles(storage, page),
    };
    const fake = fakeContext(definition, {
      params: { keep: true, ...params },
      inputs: { clear },
      services: { session: session as never },
    });
    const node = create(fake.ctx);
    const { room } = fake.ctx.outputs.body;
    if (!room) throw new Error('There is no room.');
    const play = (seconds: number) => {
      for (let i = 0; i < seconds; i++) {
        fake.tick(1);
        image.frame++;
        node.update({ jumps: 0 } as never);
        clear.clear();
        // As the world answers.
        if (room.wantsFile) Object.assign(room, { file: FILE.slice(), fileChanges: room.changes });
        room.wantsFile = false;
      }
      return room.edits.splice(0);
    };
    const find = () => Object.assign(restored ?? {}, { state: 'tracked' });
    return { ...fake, play, find, clear, room };
  };
  return { visit, stored, places };
}

test('the room is there again at the next visit, at its place, once the device has found it', () => {
  const { visit, stored } = device();
  expect(visit().play(8)).toEqual([]);
  expect(stored.size).toBe(1);
  // The world of the second visit is turned and moved: what was at (2, 0, 3) is at (5, 0, 0).
  const worldFromPlace = new Matrix4().makeRotationY(Math.PI / 2).setPosition(5, 0, 0);
  const second = visit({}, worldFromPlace);
  const before = [...stored.values()];
  // Nothing replaces what is kept while its place is unknown.
  expect(second.play(20)).toEqual([]);
  expect([...stored.values()]).toEqual(before);
  second.find();
  const edits = second.play(1);
  expect(edits).toMatchObject([{ kind: 'load', file: FILE }]);
  const [edit] = edits;
  if (edit?.kind !== 'load') throw new Error('Nothing is loaded.');
  const moved = new Matrix4().fromArray([...(edit.worldFromFile as number[])]);
  expect(moved.elements.map((x) => Math.round(1e4 * x) / 1e4 + 0)).toEqual(
    worldFromPlace
      .clone()
      .multiply(new Matrix4().makeTranslation(-2, 0, -3))
      .elements.map((x) => Math.round(1e4 * x) / 1e4 + 0),
  );
  expect(second.reports).toEqual([]);
});

test('a pulse at Clear forgets it, and without the choice nothing is kept', () => {
  const { visit, stored, places } = device();
  const first = visit();
  first.play(8);
  first.clear.emit();
  first.play(1);
  expect([stored.size, places.size]).toEqual([0, 1]);
  const second = visit();
  second.find();
  expect(second.play(1)).toEqual([]);
  const none = device();
  none.visit({ keep: false }).play(20);
  expect([none.stored.size, none.places.size]).toEqual([0, 0]);
});

test.each([
  ['truncated', (text: string) => text.slice(0, 100), /^The room of an earlier visit cannot be used: It is truncated/],
  ['short', () => btoa('short'), /cannot be used: It is truncated\. It is measured anew\.$/],
  ['of another script', () => '%%%', /cannot be used: It is truncated/],
  ['something else', () => btoa('x'.repeat(400)), /cannot be used: (It is not a voxel file|Its pose is damaged)\./],
] as const)('kept bytes that are %s give a message and an empty room', (_, change, message) => {
  const { visit, stored } = device();
  visit().play(8);
  for (const [key, text] of stored) stored.set(key, change(text));
  const next = visit();
  next.play(1);
  next.find();
  expect(next.play(1)).toEqual([]);
  expect(next.reports).toMatchObject([{ code: 'SCR057', message: expect.stringMatching(message) }]);
});

test('a room of other voxels is measured anew, and a device that keeps nothing says so once', () => {
  const { visit } = device();
  visit().play(8);
  const other = visit({ edgeM: 0.1 });
  other.play(1);
  other.find();
  expect(other.play(1)).toEqual([]);
  expect(other.reports).toMatchObject([{ message: expect.stringContaining('edges of 50 mm instead of 100 mm') }]);
  const refused = device({ keeps: false });
  const { play, reports } = refused.visit();
  play(20);
  expect(reports).toMatchObject([{ code: 'SCR057', severity: 'info' }]);
  expect(refused.stored.size).toBe(0);
});
