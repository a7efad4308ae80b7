import { describe, expect, test } from '@jest/globals';
import { Box3, type Mesh } from 'three';
import { compile } from '../../../export/compiler/compile.ts';
import { loadProject } from '../../../export/graph/load.ts';
import { LIBRARY } from '../../../tests/support/library.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { signedVolumeM3 } from '../../../tests/support/signed-volume.ts';
import type { ParamValue } from '../../kit/definition.ts';
import { readGlyphs, subsetGlyphs } from '../../kit/glyphs.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const FONT = LIBRARY.shader('fonts/inter') ?? '';
const CAPITAL = readGlyphs(FONT).capitalHeight;

function start(text: string, params: Readonly<Record<string, ParamValue>> = {}) {
  const outlines = subsetGlyphs(FONT, text);
  const { ctx, set, reports } = fakeContext(definition, { params: { text, characters: outlines, ...params } });
  const node = create(ctx);
  const list = ctx.outputs.objects;
  const update = () => {
    node.update({} as never);
    return list.items[0]?.root as Mesh | undefined;
  };
  const box = () => {
    const mesh = update();
    if (!mesh) throw new Error('There is no text.');
    const { min, max } = new Box3().setFromBufferAttribute(mesh.geometry.getAttribute('position') as never).applyMatrix4(mesh.matrixWorld);
    return { min: min.toArray(), max: max.toArray() };
  };
  return { node, list, set, reports, update, box };
}

/** Area between the contours of a character with quadratic curves in four straight parts, in capital letters squared. */
function outlineArea(character: string): number {
  const path = readGlyphs(FONT).byCharacter.get(character)?.path ?? '';
  let area = 0;
  let from: number[] = [];
  let first: number[] = [];
  const line = (to: number[]) => {
    area += ((from[0] ?? 0) * (to[1] ?? 0) - (to[0] ?? 0) * (from[1] ?? 0)) / 2;
    from = to;
  };
  for (const [, command, numbers = ''] of path.matchAll(/([A-Z])([^A-Z]*)/g)) {
    const [a = 0, b = 0, c = 0, d = 0] = numbers.split(' ').map((n) => Number(n) / CAPITAL);
    if (command === 'M') from = first = [a, b];
    if (command === 'L') line([a, b]);
    if (command === 'Z') line(first);
    if (command !== 'Q') continue;
    const [x = 0, y = 0] = from;
    for (const t of [0.25, 0.5, 0.75, 1]) {
      const s = 1 - t;
      line([s * s * x + 2 * s * t * a + t * t * c, s * s * y + 2 * s * t * b + t * t * d]);
    }
  }
  return Math.abs(area);
}

describe('objects/text-3d', () => {
  test('a capital letter is as high as the size, on the baseline, from z = 0 to the depth', () => {
    const { box } = start('H', { sizeM: 0.2, depthM: 0.05 });
    const { min, max } = box();
    expect(min[1]).toBeCloseTo(0, 6);
    expect(max[1]).toBeCloseTo(0.2, 6);
    expect([min[2], max[2]]).toEqual([0, expect.closeTo(0.05, 6)]);
    expect((min[0] ?? 0) + (max[0] ?? 0)).toBeCloseTo(0, 2);
  });

  test.each(['H', 'o', '8', 'ä', '%', '@', 'Ж', 'Θ', 'ế', '±', '°', '−'])(
    'the faces of “%s” point outward and its holes are open: its volume is the area of its outline times the depth',
    (character) => {
      const mesh = start(character).update();
      expect(signedVolumeM3((mesh as Mesh).geometry)).toBeCloseTo(outlineArea(character), 4);
    },
  );

  test('aligns lines at the origin, and stands on it, hangs from it or is centered at it', () => {
    const left = start('HHH\\nH', { sizeM: 1, align: 'left', vertical: 'top', lineHeight: 2 }).box();
    expect(left.min[0]).toBeGreaterThan(0);
    expect([left.min[1], left.max[1]]).toEqual([expect.closeTo(-3, 5), expect.closeTo(0, 5)]);
    const right = start('HHH\\nH', { sizeM: 1, align: 'right', vertical: 'middle', lineHeight: 2 }).box();
    expect(right.max[0]).toBeLessThan(0);
    expect([right.min[1], right.max[1]]).toEqual([expect.closeTo(-1.5, 5), expect.closeTo(1.5, 5)]);
    expect(start('HH\\nH', { sizeM: 1, lineHeight: 2 }).box().min[1]).toBeCloseTo(0, 5);
  });

  test('changes its letters with the text alone, and disposes the old ones', () => {
    const { list, set, update } = start('1.20 m');
    const { geometry } = update() as Mesh;
    let disposed = 0;
    geometry.addEventListener('dispose', () => disposed++);
    const { version } = list;
    update();
    expect([list.version, disposed]).toEqual([version, 0]);
    set('text', '0.21 m');
    expect((update() as Mesh).geometry).not.toBe(geometry);
    expect([list.version, disposed]).toEqual([version + 1, 1]);
    set('text', '   ');
    expect(update()).toBe(undefined);
  });

  test('reports characters that it has no letters for, and texts that are too long', () => {
    const { reports, update } = start(`${'m'.repeat(10_000)}`);
    update();
    expect(reports).toMatchObject([{ code: 'SCR059', port: 'text', message: expect.stringContaining('more than 200 characters') }]);
    const chinese = start('米m');
    expect(chinese.update()).not.toBe(undefined);
    expect(chinese.reports).toMatchObject([{ code: 'SCR059', message: 'There are no letters for: 米' }]);
  });

  test('a program has the letters of a fixed text, or those that a live text may have', () => {
    const text = (wires: readonly string[]) => {
      const project = {
        format: 'scrim-project',
        version: 1,
        title: 'Letters',
        graphs: {
          main: {
            nodes: {
              'choice-x1': { type: 'input/choice', version: 1 },
              'text-x1': { type: 'objects/text-3d', version: 1, params: { text: { port: 'Ohm' }, characters: 'Abc' } },
              'scene-x1': { type: 'layer/scene', version: 1 },
              'screen-x1': { type: 'output/screen', version: 1 },
            },
            wires: ['text-x1.objects -> scene-x1.objects', 'scene-x1.layer -> screen-x1.layer', ...wires],
          },
        },
      };
      const loaded = loadProject({ project: JSON.stringify(project), layout: null, sources: {} });
      if (!loaded.output) throw new Error(JSON.stringify(loaded.diagnostics));
      const compiled = compile({ project: loaded.output, library: LIBRARY });
      const operation = compiled.output?.operations.find((op) => 'type' in op && op.type === 'objects/text-3d');
      if (!operation || !('config' in operation)) throw new Error(JSON.stringify(compiled.diagnostics));
      return [...readGlyphs(String(operation.config.characters)).byCharacter.keys()].join('');
    };
    expect(text([])).toBe('Ohm');
    expect(text(['choice-x1.word -> text-x1.text'])).toBe('Abc');
  });

  test('releases its geometry and material', () => {
    const { node, update } = start('A');
    const { geometry, material } = update() as Mesh;
    let released = 0;
    for (const each of [geometry, material]) (each as Mesh['geometry']).addEventListener('dispose', () => released++);
    node.dispose();
    expect(released).toBe(2);
  });
});
