import { resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { DEFINITIONS, SHADERS } from '../../../nodes/generated/definitions.gen.ts';
import { libraryOf } from '../../../nodes/kit/definition.ts';
import { videoStudio } from '../../../tests/compile/graphs.ts';
import { compile } from '../../compiler/compile.ts';
import { type CompileWork, compileApart } from './compile-apart.ts';

const ROOT = resolve(import.meta.dirname, '../../..');
const work: CompileWork = { project: videoStudio().project, definitions: DEFINITIONS, shaders: SHADERS, options: { sourceMaps: false } };

test('a thread of its own compiles as this one does', async () => {
  const here = compile({ project: work.project, library: libraryOf(DEFINITIONS, SHADERS), options: work.options });
  expect(here.output).not.toBeNull();
  expect(await compileApart(ROOT, work)).toEqual(here);
});

test('who has had enough is told so by the reason they gave', async () => {
  const enough = new AbortController();
  const compiling = compileApart(ROOT, work, enough.signal);
  const reason = new Error('enough');
  enough.abort(reason);
  await expect(compiling).rejects.toBe(reason);
});
