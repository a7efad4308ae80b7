import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { writeProject } from '../support/project-kit.ts';
import { scrim } from '../support/scrim.ts';

const HEADER = '/*{ "ISFVSN": "2" }*/\n';

/** Sums of so many bytes. */
function sums(bytes: number): string {
  return `${HEADER}void main() { float a = 0.0;\n${'a+=0.001;\n'.repeat(bytes / 10)} gl_FragColor = vec4(a); }`;
}

function chain(length: number): string {
  const calls = Array.from({ length }, (_, i) => `float f${i + 1}(float x) { return f${i}(x); }`);
  return `${HEADER}float f0(float x) { return x; }\n${calls.join('\n')}\nvoid main() { gl_FragColor = vec4(f${length}(1.0)); }`;
}

let folder = '';
beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'scrim-limits-'));
  await writeProject(folder, {
    'a-fine.fs': `${HEADER}void main() { gl_FragColor = vec4(1.0); }`,
    'b-chain.fs': chain(200),
    'c-long-chain.fs': chain(3000),
    'd-heavy.fs': sums(600_000),
    'e-huge.fs': sums(5_000_000),
    'f-fine.fs': `${HEADER}void main() { gl_FragColor = vec4(0.5); }`,
  });
});
afterAll(() => rm(folder, { recursive: true, force: true }));

test('a file that is too much for anybody is told as that, and leaves the others their verdicts', async () => {
  const { status, out } = await scrim('shader', 'check', folder, '--json');
  const { files } = JSON.parse(out) as { files: { path: string; ok: boolean; diagnostics: { message: string }[] }[] };
  expect([status, files.length]).toEqual([1, 6]);
  const [fine, chained, tooDeep, , huge, last] = files;
  expect([fine, chained, last].map((file) => [file?.ok, file?.diagnostics])).toEqual(Array(3).fill([true, []]));
  expect(tooDeep).toMatchObject({ ok: false, diagnostics: [{ message: expect.stringContaining('256 deep') }] });
  // On a busy machine it is the time that ends it.
  expect(huge).toMatchObject({ ok: false, diagnostics: [{ message: expect.stringMatching(/too long|took longer than 10 s/) }] });
});
