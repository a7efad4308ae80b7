import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { ball, createLab } from '../../../tests/support/physics/lab.ts';
import { BOX, SEEN_BOX, SETTINGS } from '../../../tests/support/physics/seen-room.ts';
import { readVoxelFile, writeVoxelFile } from '../../kit/voxel-file.ts';
import { createVoxelGrid, type VoxelGrid } from '../world/voxel-grid.ts';

describe('a grid that is saved', () => {
  const seen = (isSmooth = false) => {
    const grid = createVoxelGrid({ ...SETTINGS, isSmooth });
    for (let i = 0; i < 20; i++) grid.update(SEEN_BOX);
    return grid;
  };
  const occupied = (grid: VoxelGrid) => {
    const all = new Set<string>();
    grid.forEachOccupied((...at) => all.add(at.join(' ')));
    return all;
  };
  const identity = new Matrix4().elements;
  const fileOf = (grid: VoxelGrid) => writeVoxelFile(grid.save());
  const voxelsIn = (bytes: Uint8Array) => {
    const { voxels } = readVoxelFile(bytes);
    if (!voxels) throw new Error('There are no voxels.');
    return voxels;
  };

  test('has the same voxels when it is loaded, and the same file again', () => {
    const grid = seen();
    const file = fileOf(grid);
    const other = createVoxelGrid(SETTINGS);
    other.load(voxelsIn(file), identity);
    expect(occupied(other)).toEqual(occupied(grid));
    expect(fileOf(other)).toEqual(file);
  });

  test('is turned and moved with world space, without holes that a ball of 3 cm falls through', () => {
    for (const isSmooth of [false, true]) {
      const lab = createLab({ sleep: true });
      lab.engine.apply({ kind: 'room', room: { ...SETTINGS, isSmooth }, friction: 0.6, restitution: 0.1 });
      const move = new Matrix4().makeRotationY(0.7).setPosition(1.013, 0.23, -2.04);
      lab.engine.apply({ kind: 'load-room', file: fileOf(seen(isSmooth)), worldFromFile: move.elements });
      const ids = Array.from({ length: 25 }, (_, i) => {
        const at = new Vector3(0.08 * ((i % 5) - 2), 0.5, 0.08 * (Math.floor(i / 5) - 2)).applyMatrix4(move);
        return lab.add({ shapes: ball(0.03), rollingM: 0.005 }, { positionM: [at.x, at.y, at.z] });
      });
      lab.run(4);
      // The box is 0.38 m high, the voxels 0.05.
      for (const id of ids) expect(Math.abs(lab.body(id).positionM[1] - 0.23 - BOX.top - 0.03)).toBeLessThan(isSmooth ? 0.02 : 0.06);
    }
  });

  test('moved there and back, it has nearly all voxels again', () => {
    const grid = seen();
    const before = occupied(grid);
    const move = new Matrix4().makeRotationY(1.2).setPosition(0.31, -0.02, 0.77);
    grid.load(grid.save(), move.elements);
    grid.load(grid.save(), move.clone().invert().elements);
    const after = occupied(grid);
    const kept = [...after].filter((at) => before.has(at)).length;
    expect(kept / before.size).toBeGreaterThan(0.6);
    expect(after.size / before.size).toBeGreaterThan(0.9);
    expect(after.size / before.size).toBeLessThan(1.1);
  });

  test('that is truncated, damaged, of another version or something else says so', () => {
    const file = fileOf(seen());
    const changed = (at: number, value: number) => Uint8Array.from(file, (byte, i) => (i === at ? value : byte));
    const problem = (bytes: Uint8Array) => readVoxelFile(bytes).problem;
    expect(problem(file)).toBeNull();
    expect(problem(new Uint8Array())).toBe('It is not a voxel file.');
    expect(problem(new TextEncoder().encode('{"format": "scrim-session"}'))).toBe('It is not a voxel file.');
    expect(problem(file.slice(0, 10))).toBe('It is truncated.');
    expect(problem(file.slice(0, -3))).toBe(`It is truncated: it has ${file.length - 3} of ${file.length} bytes.`);
    expect(problem(Uint8Array.of(...file, 0))).toBe('It has more bytes than its voxels need.');
    expect(problem(changed(4, 2))).toBe('It has version 2; this program reads version 1.');
    expect(problem(changed(40, 77))).toBe('It is damaged: its checksum differs.');
    expect(problem(changed(15, 255))).toBe('Its header is damaged.');
    const lab = createLab();
    lab.engine.apply({ kind: 'room', room: SETTINGS, friction: 0, restitution: 0 });
    lab.engine.apply({ kind: 'load-room', file, worldFromFile: identity });
    expect(lab.engine.voxels().length).toBeGreaterThan(600);
    lab.engine.apply({ kind: 'load-room', file: file.slice(0, 99), worldFromFile: identity });
    expect(lab.engine.voxels()).toHaveLength(0);
  });
});
