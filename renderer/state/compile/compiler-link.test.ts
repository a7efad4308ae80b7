import { expect, test } from '@jest/globals';
import { newProject } from '../../../export/graph/new-project.ts';
import type { CompileAnswer, CompileRequest } from './compiler-link.ts';
import { type CompilerWorker, createCompilerLink } from './compiler-link.ts';

function createStandIn() {
  const asked: number[] = [];
  const worker: CompilerWorker = {
    postMessage: ({ revision }: CompileRequest) => void asked.push(revision),
    onmessage: null,
    terminate: () => {},
  };
  const answer = (revision: number) => {
    const data: CompileAnswer = { revision, program: null, diagnostics: [], above: [], tookMs: 1 };
    worker.onmessage?.({ data } as MessageEvent<CompileAnswer>);
  };
  return { worker, asked, answer };
}

test('one request at a time, and of those that wait only the newest', () => {
  const { worker, asked, answer } = createStandIn();
  const answered: [number, boolean][] = [];
  const link = createCompilerLink(worker, ({ revision }, more) => void answered.push([revision, more]));
  const { layout: _, ...project } = newProject('Test');
  for (const revision of [1, 2, 3, 4]) link.request({ revision, project, taps: [], thumbnails: [] });
  expect(asked).toEqual([1]);
  answer(1);
  expect(asked).toEqual([1, 4]);
  answer(4);
  expect(answered).toEqual([
    [1, true],
    [4, false],
  ]);
  link.request({ revision: 5, project, taps: [], thumbnails: [] });
  expect(asked).toEqual([1, 4, 5]);
});
