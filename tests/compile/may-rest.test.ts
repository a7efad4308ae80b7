import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { mayRest } from '../../export/program/may-rest.ts';
import { compileExample } from '../support/compile-project.ts';
import { TESTS_FOLDER } from '../support/this-test.ts';

const example = (name: string) => compileExample(join(TESTS_FOLDER, '../examples', name));

test.each([
  'built-of-bricks',
  'first-light',
  'marble-run',
  'shadows-of-real-and-virtual-things',
  'the-world-in-the-book',
  'warm-and-cold-light',
])('objects of %s need not be drawn again while nothing changes', async (name) => {
  expect(mayRest(await example(name))).toBe(true);
});

test.each([
  ['lit-as-the-room-is', 'the estimate of the light gives no sign'],
  ['boards/gallery', 'a layer shows the previous frame'],
])('%s is drawn in every frame: %s', async (name) => {
  expect(mayRest(await example(name))).toBe(false);
});

test('objects are drawn in every frame under a technique or a filter that reads the clock', async () => {
  const program = await example('built-of-bricks');
  const clocked = { name: 'TIME', type: 'float', source: { builtin: 'TIME' } } as const;
  const resources = program.resources.map((resource) =>
    resource.kind === 'technique' ? { ...resource, fragment: `${resource.fragment}\nfloat phase() { return a_TIME; }` } : resource,
  );
  expect(mayRest({ ...program, resources })).toBe(false);
  const filtered = await example('warm-and-cold-light');
  const operations = filtered.operations.map((operation) =>
    operation.kind === 'pass' ? { ...operation, uniforms: [clocked] } : operation,
  );
  expect(mayRest({ ...filtered, operations })).toBe(false);
});
