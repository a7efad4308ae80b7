import { mkdir, mkdtemp, readdir, readFile, realpath, rm, symlink, truncate, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { loadProject } from '../../export/graph/load.ts';
import { saveProject } from '../../export/graph/save.ts';
import { type ProjectText, projectText, writeProject } from '../../tests/support/project-kit.ts';
import { scrim as scrimAsGiven } from '../../tests/support/scrim.ts';
import { installationAt } from '../services/installation.ts';
import { readProjectFiles } from '../services/project-files.ts';
import { EXIT } from './command.ts';
import { COMMANDS, runCli } from './run-cli.ts';

const INSTALLATION = installationAt(resolve(import.meta.dirname, '../..'), '1.2.3');
const MODEL = resolve(import.meta.dirname, '../../examples/first-light/assets/robot.glb');

/** A tinted camera picture with a model before it. */
const GOOD: ProjectText = {
  title: 'Robot',
  nodes: {
    'video-a1b2': 'source/camera-video',
    'robot-c3d4': ['source/model', { model: 'robot' }],
    'scene-e5f6': 'layer/scene',
    'over-g7h8': 'operator/over',
    'sepia-j9k2': 'filter/sepia',
    'screen-m3n4': 'output/screen',
  },
  wires: [
    'robot-c3d4.objects -> scene-e5f6.objects',
    'scene-e5f6.layer -> over-g7h8.top',
    'video-a1b2.layer -> over-g7h8.bottom',
    'over-g7h8.layer -> sepia-j9k2.inputImage',
    'sepia-j9k2.layer -> screen-m3n4.layer',
  ],
  assets: { robot: { path: 'assets/robot.glb', kind: 'model' } },
};

const OWN_WITH_IMAGE = `/*{ "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }], "IMPORTED": { "leak": { "PATH": "leak.png" } } }*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) + IMG_THIS_PIXEL(leak); }
`;

let base = '';
let project = '';
beforeEach(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-cli-'));
  project = join(base, 'project');
  await write(GOOD);
});
afterEach(() => rm(base, { recursive: true, force: true }));

async function write(text: ProjectText, files: Readonly<Record<string, string>> = {}): Promise<void> {
  await writeProject(project, { 'project.scrim.json': projectText(text), 'assets/robot.glb': await readFile(MODEL), ...files });
}

/** A poster takes a browser and seconds, and so does compression: `tests/slow/page-poster.test.ts` has one drawn. */
const quick = (args: readonly string[]): string[] => (args[0] === 'export' ? [...args, '--no-poster', '--no-compress'] : [...args]);

const scrim = (...args: string[]) => scrimAsGiven(...quick(args));

interface JsonAnswer {
  readonly ok: boolean;
  readonly diagnostics: readonly { readonly code: string; readonly severity: string; readonly message: string; readonly nodeId?: string }[];
}

/** What is printed with `--json` is one value and nothing else. */
async function scrimJson(...args: string[]) {
  const { status, out, err } = await scrim(...args, '--json');
  expect(err).toBe('');
  return { status, json: JSON.parse(out) as JsonAnswer };
}

async function tree(folder: string): Promise<Record<string, string>> {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true }).catch(() => []);
  const files = entries.filter((entry) => entry.isFile()).map((entry) => join(entry.path, entry.name));
  const contents = await Promise.all(files.map(async (path) => [path.slice(folder.length + 1), await readFile(path, 'base64')] as const));
  return Object.fromEntries(contents.sort(([a], [b]) => (a < b ? -1 : 1)));
}

describe('the command line', () => {
  test('explains itself, and every command with its options and an example', async () => {
    const overview = await scrim('--help');
    expect(overview.status).toBe(0);
    for (const status of Object.values(EXIT)) expect(overview.out).toMatch(new RegExp(`^ +${status} {2}\\S`, 'm'));
    for (const { name, options, examples } of COMMANDS) {
      expect(examples.length).toBeGreaterThanOrEqual(2);
      for (const { line } of examples) expect(line).toMatch(new RegExp(`^scrim ${name} `));
      expect(overview.out).toContain(`  ${name}`);
      const help = await scrim(...name.split(' '), '--help');
      expect(help.status).toBe(0);
      expect(help.err).toBe('');
      for (const option of [...Object.keys(options), 'json', 'help']) expect(help.out).toContain(`--${option}`);
      expect(help.out).toContain(`scrim ${name} `);
      for (const line of help.out.split('\n')) expect(line.length).toBeLessThanOrEqual(110);
    }
    expect(await scrim('--version')).toEqual({ status: 0, out: '1.2.3', err: '' });
    expect(await scrim('help', 'check')).toEqual(await scrim('check', '-h'));
  });

  test.each([
    ['nothing', [], ''],
    ['an unknown command', ['exprot', '.'], 'Unknown command "exprot". Did you mean "export"?'],
    ['a command that is near to none', ['build', '.'], 'Unknown command "build".'],
    ['help on an unknown command', ['help', 'chekc'], 'Did you mean "check"?'],
    ['an unknown option', ['check', '.', '--verbose'], 'Unknown option --verbose.'],
    ['an option written wrongly', ['export', '.', '--ouy', 'site'], 'Unknown option --ouy. Did you mean "--out"?'],
    ['no name for a project', ['new'], 'NAME is missing: the folder of the new project.'],
    ['a template that is none', ['new', 'x', '--template', 'oclusion'], 'Did you mean "occlusion"? Templates: empty, filter, occlusion.'],
    ['no project', ['check'], 'PROJECT is missing'],
    ['two projects', ['check', 'a', 'b'], 'Too many arguments'],
    ['no place for a page', ['export', '.'], '--out DIR is missing'],
    ['an option without its value', ['export', '.', '--out'], "'--out"],
    ['no place for pictures', ['render', '.'], '--out FILE.png or --out DIR is missing'],
    ['frames that are none', ['render', '.', '--out', 'x.png', '--frames', '3-4'], '--frames 3-4 is not a range'],
    ['frames backwards', ['render', '.', '--out', 'x', '--frames', '4..3'], 'ends before it begins'],
    ['several frames for one picture', ['render', '.', '--out', 'x.png', '--frames', '0..1'], 'Name a folder'],
    ['a size that is none', ['render', '.', '--out', 'x.png', '--size', '0x20'], '--size 0x20 is not a size'],
    ['a port that is none', ['open', '--port', 'web'], '--port web is not a port'],
  ])('does not understand %s: status 2, and says what would be right', async (_name, args, words) => {
    const { status, out, err } = await scrim(...args);
    expect(status).toBe(2);
    expect(args.length === 0 ? out : err).toContain(words);
    if (args.length === 0 || args[0] === 'help') return;
    expect(out).toBe('');
    const json = await scrimJson(...args);
    expect(json).toMatchObject({ status: 2, json: { ok: false, diagnostics: [{ code: 'SCR070' }] } });
  });
});

describe('scrim check', () => {
  test('finds nothing wrong with a good project, named by its folder or its file', async () => {
    expect(await scrim('check', project)).toEqual({ status: 0, out: 'No problems found.', err: '' });
    expect(await scrimJson('check', join(project, 'project.scrim.json'))).toEqual({
      status: 0,
      json: { ok: true, driver: 'not-needed', diagnostics: [] },
    });
  });

  test('prints where and what, one line each; in color on a terminal', async () => {
    await write({ ...GOOD, nodes: { ...GOOD.nodes, 'sepia-j9k2': 'filter/sepai' } });
    const { status, out } = await scrim('check', project);
    expect(status).toBe(1);
    expect(out).toMatch(/^sepia-j9k2: error SCR010: .+/m);
    const painted: string[] = [];
    const streams = { out: (text: string) => painted.push(text), err: () => {}, interactive: true, colored: { out: true, err: true } };
    await runCli(['check', project], INSTALLATION, streams);
    expect(painted.join('\n')).toContain('sepia-j9k2: \x1b[1;31merror SCR010\x1b[0m: ');
  });

  test('names nodes by title and id, and by id alone in JSON', async () => {
    await write({ ...GOOD, wires: GOOD.wires.slice(0, -2).concat(GOOD.wires.slice(-1)) });
    const { out } = await scrim('check', project);
    expect(out).toMatch(/^Sepia \(sepia-j9k2\)\.inputImage: error SCR015: .*Sepia \(sepia-j9k2\)/m);
    const { json } = await scrimJson('check', project);
    expect(json).toMatchObject({
      diagnostics: expect.arrayContaining([expect.objectContaining({ code: 'SCR015', nodeId: 'sepia-j9k2' })]),
    });
    const plan = await scrim('plan', project);
    expect(plan.err).toContain('Sepia (sepia-j9k2)');
  });

  /** [what is wrong, how the project becomes so, code, words of the message] */
  const WRONG: readonly (readonly [string, () => Promise<unknown>, string, string])[] = [
    ['an unknown node type', () => write({ ...GOOD, nodes: { ...GOOD.nodes, 'x-y2z3': 'filter/none' } }), 'SCR010', 'filter/none'],
    ['a future version', () => edit('"version": 1', '"version": 99'), 'SCR003', '99'],
    [
      'a cycle',
      () => write({ ...GOOD, wires: [...GOOD.wires.slice(0, 2), 'sepia-j9k2.layer -> over-g7h8.bottom', ...GOOD.wires.slice(3)] }),
      'SCR014',
      'sepia-j9k2',
    ],
    [
      'ports of two types',
      () => write({ ...GOOD, wires: [...GOOD.wires, 'video-a1b2.layer -> scene-e5f6.lights'] }),
      'SCR013',
      'scene-e5f6',
    ],
    [
      'a missing picture of a shader',
      () => write({ ...GOOD, nodes: { ...GOOD.nodes, 'sepia-j9k2': 'filter/own' } }, { 'shaders/own.fs': OWN_WITH_IMAGE }),
      'SCR030',
      'shaders/leak.png',
    ],
    ['a missing asset', () => rm(join(project, 'assets', 'robot.glb')), 'SCR030', 'assets/robot.glb'],
    ['a model that is cut off', () => truncate(join(project, 'assets', 'robot.glb'), 1000), 'SCR032', 'is incomplete'],
    ['a model that is none', () => writeFile(join(project, 'assets', 'robot.glb'), 'hello, world'), 'SCR032', 'not a glTF model'],
    [
      'an asset outside the project',
      () => write({ ...GOOD, assets: { robot: { path: '../robot.glb', kind: 'model' } } }),
      'SCR031',
      'robot',
    ],
    ['an asset behind a link', linkAsset, 'SCR031', 'assets/robot.glb'],
    ['a number that is none', () => edit('"model": "robot"', '"model": "robot", "speed": 1e999'), 'SCR006', 'finite'],
    ['a param of another type', () => edit('"model": "robot"', '"model": "robot", "speed": "fast"'), 'SCR018', 'robot-c3d4'],
    ['broken JSON', () => edit('"wires"', '"wires'), 'SCR001', ''],
    ['another shape', () => edit('"graphs"', '"grahps"'), 'SCR002', ''],
    [
      'a broken shader header',
      () =>
        write(
          { ...GOOD, nodes: { ...GOOD.nodes, 'sepia-j9k2': 'filter/own' } },
          { 'shaders/own.fs': '/*{ "INPUTS": [ }*/ void main() {}' },
        ),
      'SCR040',
      '',
    ],
    [
      'a shader that does not parse',
      () =>
        write(
          { ...GOOD, nodes: { ...GOOD.nodes, 'sepia-j9k2': 'filter/own' } },
          { 'shaders/own.fs': OWN.replace('gl_FragColor', '(gl_FragColor') },
        ),
      'SCR041',
      '',
    ],
  ];

  async function edit(from: string, to: string): Promise<void> {
    const text = projectText(GOOD);
    expect(text).toContain(from);
    await writeFile(join(project, 'project.scrim.json'), text.replace(from, to));
  }

  async function linkAsset(): Promise<void> {
    await rm(join(project, 'assets', 'robot.glb'));
    await symlink(MODEL, join(project, 'assets', 'robot.glb'));
  }

  test.each(WRONG)('says what is wrong, and an export leaves its folder as it was: %s', async (_name, damage, code, words) => {
    const out = join(base, 'site');
    await scrim('export', project, '--out', out);
    const before = await tree(out);
    expect(Object.keys(before).length).toBeGreaterThan(3);
    await damage();
    const { status, json } = await scrimJson('check', project);
    expect([status, json.ok]).toEqual([1, false]);
    const found = json.diagnostics.find((diagnostic) => diagnostic.code === code && diagnostic.severity === 'error');
    expect(json.diagnostics.map((diagnostic) => diagnostic.code)).toContain(code);
    expect(JSON.stringify(found)).toContain(words);
    const exported = await scrimJson('export', project, '--out', out);
    expect([exported.status, exported.json.ok]).toEqual([1, false]);
    expect(await tree(out)).toEqual(before);
  });
});

const OWN = `/*{ "ISFVSN": "2", "INPUTS": [ { "NAME": "inputImage", "TYPE": "image" } ] }*/
void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }
`;

describe('scrim new', () => {
  test.each(['empty', 'filter', 'occlusion'])('makes a project that is whole: %s', async (template) => {
    const path = join(base, 'my-first_effect');
    const { status, out, err } = await scrim('new', path, '--template', template);
    expect([status, err]).toEqual([0, '']);
    expect(out).toContain(`scrim open ${path}`);
    expect(await scrim('check', path)).toEqual({ status: 0, out: 'No problems found.', err: '' });
    const { title, page } = JSON.parse(await readFile(join(path, 'project.scrim.json'), 'utf8'));
    expect(title).toBe('My first effect');
    // The description of a template is about the template.
    expect(page?.description).toBeUndefined();
    expect(await scrim('export', path, '--out', join(base, 'site'))).toMatchObject({ status: 0, err: '' });
    const help = await scrim('new', '--help');
    expect(help.out.replace(/\s+/g, ' ')).toContain(`${template}: `);
  });

  test('begins with the camera’s picture unless told otherwise, and says where it is', async () => {
    const { status, json } = await scrimJson('new', join(base, 'mine'));
    expect([status, json]).toEqual([0, { ok: true, path: await realpath(join(base, 'mine')), template: 'empty' }]);
    await scrim('new', join(base, 'same'), '--template', 'empty');
    expect(await readFile(join(base, 'mine', 'project.layout.json'), 'utf8')).toBe(
      await readFile(join(base, 'same', 'project.layout.json'), 'utf8'),
    );
  });

  test('refuses a folder that holds something, and leaves it alone', async () => {
    const before = await tree(project);
    expect(await scrimJson('new', project)).toMatchObject({ status: 1, json: { diagnostics: [{ code: 'SCR061' }] } });
    expect(await tree(project)).toEqual(before);
  });

  test('the templates that come with Scrim are written as Scrim writes them', async () => {
    const templates = INSTALLATION.templatesDir;
    const names = await readdir(templates);
    expect(names.sort()).toEqual(['empty', 'filter', 'occlusion']);
    for (const name of names) {
      const files = await readProjectFiles(join(templates, name));
      const { output, diagnostics } = loadProject(files);
      expect([name, diagnostics]).toEqual([name, []]);
      expect(output && saveProject(output)).toEqual(files);
    }
  });
});

describe('scrim plan', () => {
  test('tells the program in words, and as JSON', async () => {
    const { status, out } = await scrim('plan', project);
    expect(status).toBe(0);
    for (const words of ['Robot', 'scene-e5f6', 'filters/sepia.fs', 'the camera image', 'Any other browser']) expect(out).toContain(words);
    expect(out).not.toContain('Layers that are not fused');
    expect((await scrim('plan', project, '--why')).out).toContain('Layers that are not fused');
    const { json } = await scrimJson('plan', project);
    expect(json).toMatchObject({ ok: true, program: { format: 'scrim-program', title: 'Robot' } });
  });
});

describe('scrim export', () => {
  test('writes a page that holds what its report says, and the same bytes each time', async () => {
    const { status, json } = await scrimJson('export', project, '--out', join(base, 'one'));
    expect(status).toBe(0);
    expect(json).toMatchObject({
      ok: true,
      report: { title: 'Robot', features: { required: [], optional: ['local-floor', 'camera-access'] } },
    });
    await scrim('export', project, '--out', join(base, 'two'));
    const [one, two] = [await tree(join(base, 'one')), await tree(join(base, 'two'))];
    expect(Object.keys(one).some((path) => /^assets\/robot-[0-9a-f]{10}\.glb$/.test(path))).toBe(true);
    expect(two).toEqual(one);
  });

  test('takes a project’s own shader along', async () => {
    await write({ ...GOOD, nodes: { ...GOOD.nodes, 'sepia-j9k2': 'filter/own' } }, { 'shaders/own.fs': OWN });
    expect(await scrim('export', project, '--out', join(base, 'site'))).toMatchObject({ status: 0, err: '' });
  });

  test('stops when it is interrupted, and leaves what was there', async () => {
    const out = join(base, 'site');
    await scrim('export', project, '--out', out);
    const before = await tree(base);
    await write({ ...GOOD, title: 'Changed' });
    const interruption = new AbortController();
    const said: string[] = [];
    const streams = {
      out: (text: string) => said.push(text),
      err: (text: string) => said.push(text),
      interactive: true,
      // As soon as the first file of the new page is being written.
      progress: (text: string | null) => text?.startsWith('Writing') && interruption.abort(),
    };
    expect(await runCli(quick(['export', project, '--out', out]), INSTALLATION, streams, interruption.signal)).toBe(EXIT.interrupted);
    expect(said).toEqual(['Interrupted. Nothing was written.']);
    const after = await tree(base);
    expect(Object.keys(after)).toEqual(Object.keys(before));
    expect(after['site/index.html']).toBe(before['site/index.html']);
  });

  test('refuses a folder with foreign files, and one that cannot be written', async () => {
    const out = join(base, 'mine');
    await mkdir(out);
    await writeFile(join(out, 'thesis.doc'), 'mine');
    expect(await scrimJson('export', project, '--out', out)).toMatchObject({ status: 1, json: { diagnostics: [{ code: 'SCR061' }] } });
    expect(Object.keys(await tree(out))).toEqual(['thesis.doc']);
    const below = join(out, 'thesis.doc', 'site');
    expect(await scrimJson('export', project, '--out', below)).toMatchObject({ status: 1, json: { diagnostics: [{ code: 'SCR060' }] } });
  });
});

describe('scrim shader import', () => {
  const source = () => join(base, 'Deep Rings.glsl');
  const out = () => join(base, 'rings.fs');
  beforeEach(() =>
    writeFile(source(), '// by Ada, 2020\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(p / iResolution.xy, iTime, 1.0); }'),
  );

  test('writes an ISF file that says whose it is, and overwrites nothing', async () => {
    const made = await scrimJson('shader', 'import', source(), '--out', out());
    expect(made).toMatchObject({ status: 0, json: { ok: true, out: out(), credit: 'by Ada, 2020', diagnostics: [] } });
    const text = await readFile(out(), 'utf8');
    expect(text).toContain('"LICENSE": "CC BY-NC-SA 3.0 (the default of shadertoy.com: the source names no license)"');
    await writeFile(out(), 'mine');
    const again = await scrim('shader', 'import', source(), '--out', out());
    expect(again.status).toBe(EXIT.problems);
    expect(again.err).toContain('already exists');
    expect(await readFile(out(), 'utf8')).toBe('mine');
  });

  test('refuses what is no such source, and what is not there', async () => {
    await writeFile(source(), 'void main() {}');
    const other = await scrim('shader', 'import', source(), '--out', out());
    expect(other).toMatchObject({ status: EXIT.problems });
    expect(other.err).toContain('SCR045');
    expect((await scrim('shader', 'import', join(base, 'none.glsl'))).status).toBe(EXIT.notUnderstood);
    expect(await readdir(base)).not.toContain('rings.fs');
  });
});

test.each([
  [['--out', 'report', '--method', 'splats'], EXIT.notUnderstood, '--method needs one of plain, nearest, lumigraph'],
  [['--out', 'report', '--blended', '9'], EXIT.notUnderstood, '--blended needs a whole number from 1 to 4'],
  [[], EXIT.notUnderstood, '--out DIR is missing'],
  [['--out', 'report'], EXIT.problems, 'is not a capture: it has no capture.json'],
])('rephotograph %j of a project is refused', async (options, status, reason) => {
  const said = await scrim('rephotograph', project, ...options);
  expect([said.status, said.err]).toEqual([status, expect.stringContaining(reason)]);
});
