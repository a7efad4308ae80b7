import { mkdtemp, readdir, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { projectText, writeProject } from '../../tests/support/project-kit.ts';
import { scrim } from '../../tests/support/scrim.ts';

const OWN = `/*{ "ISFVSN": "2", "INPUTS": [ { "NAME": "inputImage", "TYPE": "image" } ] }*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }
`;

let base = '';
let project = '';
const former = process.env.SCRIM_CHROMIUM;
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-cli-'));
  project = join(base, 'project');
  process.env.SCRIM_CHROMIUM = join(base, 'nowhere', 'chromium');
  const text = projectText({
    nodes: { 'video-a1b2': 'source/camera-video', 'own-a1b2': 'filter/own', 'screen-a1b2': 'output/screen' },
    wires: ['video-a1b2.layer -> own-a1b2.inputImage', 'own-a1b2.layer -> screen-a1b2.layer'],
  });
  await writeProject(project, { 'project.scrim.json': text, 'shaders/own.fs': OWN });
});
afterEach(async () => {
  if (former === undefined) delete process.env.SCRIM_CHROMIUM;
  else process.env.SCRIM_CHROMIUM = former;
  await rm(base, { recursive: true, force: true });
});

describe('where no browser starts', () => {
  test('a check is done, and says that no driver was asked', async () => {
    const { status, out } = await scrim('check', project, '--json');
    const answer = JSON.parse(out) as { readonly diagnostics: readonly { readonly message: string }[] };
    expect([status, answer]).toMatchObject([0, { ok: true, driver: 'no-browser', diagnostics: [{ code: 'SCR071', severity: 'warning' }] }]);
    expect(answer.diagnostics[0]?.message).toContain('not checked by a graphics driver');
    expect(await scrim('check', project, '--no-driver')).toEqual({ status: 0, out: 'No problems found.', err: '' });
  });

  test('a page is exported, and says that no driver was asked, and that it has no picture', async () => {
    const { status, err } = await scrim('export', project, '--out', join(base, 'site'), '--no-compress');
    expect(status).toBe(0);
    expect(err).toMatch(/^warning SCR065: /m);
    expect(err).toMatch(/^warning SCR071: .*does not start/m);
    expect(await readdir(join(base, 'site'))).toContain('index.html');
  });

  test('a render says what does not start', async () => {
    const { status, err } = await scrim('render', project, '--out', join(base, 'picture.png'));
    expect(status).toBe(1);
    expect(err).toMatch(/^error SCR071: The browser .*nowhere.chromium does not start/m);
  });
});
