import { describe, expect, test } from '@jest/globals';
import { createTechniqueStore } from './technique-store.ts';

const SOURCE =
  '/*{ "DESCRIPTION": "One color." }*/\n#include <paint/wash>\nvec4 surface(const in Surface s) { return vec4(wash(), 1.0); }\n';
const FILE = 'shaders/wash.glsl';

function linkWith(store: ReturnType<typeof createTechniqueStore>, chunks: Readonly<Record<string, string>>) {
  return store.link(FILE, SOURCE, { chunkOf: (name) => chunks[name], loopBudget: false });
}

describe('techniques that include chunks', () => {
  test('are linked anew when one of them changes, and only then', () => {
    const store = createTechniqueStore();
    const outer = '#include <paint/ink>\nvec3 wash() { return ink(); }';
    const blue = linkWith(store, { 'paint/wash': outer, 'paint/ink': 'vec3 ink() { return vec3(0.0, 0.0, 1.0); }' });
    expect(blue.output?.linked.fragment).toContain('vec3(0.0, 0.0, 1.0)');
    expect(linkWith(store, { 'paint/wash': outer, 'paint/ink': 'vec3 ink() { return vec3(0.0, 0.0, 1.0); }', other: '' })).toBe(blue);
    const red = linkWith(store, { 'paint/wash': outer, 'paint/ink': 'vec3 ink() { return vec3(1.0, 0.0, 0.0); }' });
    expect(red.output?.linked.fragment).toContain('vec3(1.0, 0.0, 0.0)');
  });

  test('tell of one that is not there, until it is', () => {
    const store = createTechniqueStore();
    expect(linkWith(store, {}).diagnostics).toMatchObject([{ code: 'SCR043', line: 2, column: 1, file: FILE }]);
    expect(linkWith(store, { 'paint/wash': 'vec3 wash() { return vec3(1.0); }' }).diagnostics).toEqual([]);
  });
});
