import { existsSync, readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { compileExample } from '../support/compile-project.ts';
import type { Held } from './held-frames.page.ts';

const EXAMPLES = resolve(import.meta.dirname, '../../examples');
const SESSION = 'examples/sessions/studio/';
const PROJECTS = readdirSync(EXAMPLES).filter((name) => existsSync(join(EXAMPLES, name, 'project.scrim.json')));
const page = useModule('tests/slow/held-frames.page.ts', { mounts: { '/examples/': EXAMPLES } });

/** Nothing of the picture moves, in no pixel and by no level. */
const STILL = { pixels: 0, most: 0, changes: [], problems: [], error: 0 };

test.each(PROJECTS)('held at a moment, “%s” is drawn the same each time', async (name) => {
  const held = await page.call<Held>('hold', await compileExample(join(EXAMPLES, name)), `examples/${name}/`, SESSION, 1.25, 3);
  expect(held).toMatchObject(STILL);
  expect(held.colors).toBeGreaterThan(200);
});
