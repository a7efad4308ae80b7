import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import { getBounds, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { expect, test } from '@jest/globals';
import { modelBounds } from '../../export/gltf/model-bounds.ts';
import { readGltf } from '../../export/gltf/read-gltf.ts';
import { describeWithData } from '../support/shared-data.ts';

describeWithData('real models', 'models', (shared) => {
  test.each(['AntiqueCamera', 'BoomBox', 'GlassTable', 'LeePerrySmith', 'VrGallery'])(
    'the box of %s is that of gltf-transform',
    async (name) => {
      const bytes = await readFile(resolve(shared, `${name}.glb`));
      const root = (await new NodeIO().registerExtensions(ALL_EXTENSIONS).readBinary(bytes)).getRoot();
      const scene = root.getDefaultScene() ?? root.listScenes()[0];
      if (!scene) throw new Error(`${name} has no scene.`);
      const { min, max } = getBounds(scene);
      const found = modelBounds(readGltf(bytes));
      const sizeM = Math.max(...max.map((end, axis) => end - (min[axis] ?? 0)));
      for (const axis of [0, 1, 2] as const) {
        expect(Math.abs((found?.min[axis] ?? Number.NaN) - (min[axis] ?? 0))).toBeLessThan(0.05 * sizeM);
        expect(Math.abs((found?.max[axis] ?? Number.NaN) - (max[axis] ?? 0))).toBeLessThan(0.05 * sizeM);
      }
    },
  );

  test('a skinned model stands in its pose of binding: the Fox is about 78 units high, on its feet', async () => {
    const bounds = modelBounds(readGltf(await readFile(resolve(shared, 'Fox.glb'))));
    expect(bounds?.min[1]).toBeCloseTo(0, 0);
    expect(bounds?.max[1]).toBeGreaterThan(70);
    expect(bounds?.max[1]).toBeLessThan(85);
  });
});
