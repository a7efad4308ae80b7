import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';

const RENDERER = resolve(import.meta.dirname, '..');

test('lists are select fields, which have type-ahead, headings and previews on all systems, never native ones', () => {
  const components = readdirSync(RENDERER, { recursive: true, encoding: 'utf8' }).filter((path) => path.endsWith('.tsx'));
  expect(components.length).toBeGreaterThan(50);
  expect(components.filter((path) => /<select\b/.test(readFileSync(join(RENDERER, path), 'utf8')))).toEqual([]);
});
