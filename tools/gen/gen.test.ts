import { mkdir, mkdtemp, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterEach, beforeEach, describe, expect, jest, test } from '@jest/globals';
import { build } from 'esbuild';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { main } from './main.ts';

const FILTER = `/*{ "ISFVSN": "2", "DESCRIPTION": "Turns black to white.", "INPUTS": [
  { "NAME": "inputImage", "TYPE": "image" },
  { "NAME": "amount", "TYPE": "float", "DEFAULT": 0.5, "MIN": 0.0, "MAX": 1.0 }
] }*/
void main() { vec4 c = IMG_THIS_PIXEL(inputImage); gl_FragColor = vec4(mix(c.rgb, 1.0 - c.rgb, amount), c.a); }
`;

function definitionFile(type: string): string {
  return `export const definition = { type: '${type}', version: 1, title: 'T', doc: 'D.', inputs: {}, outputs: {}, params: {}, lowering: { kind: 'value' } } as const;\n`;
}

describe('gen', () => {
  let root: string;
  let errors: jest.SpiedFunction<typeof console.error>;
  beforeEach(async () => {
    root = await mkdtemp(join(tmpdir(), 'scrim-gen-'));
    errors = jest.spyOn(console, 'error').mockImplementation(() => {});
  });
  afterEach(async () => {
    jest.restoreAllMocks();
    await rm(root, { recursive: true });
  });

  async function write(files: Readonly<Record<string, string>>): Promise<void> {
    for (const [path, text] of Object.entries(files)) {
      await mkdir(dirname(join(root, path)), { recursive: true });
      await writeFile(join(root, path), text);
    }
  }

  /** Imports a generated module, as a bundler takes it. */
  async function load<T>(name: string): Promise<T> {
    const { outputFiles } = await build({
      entryPoints: [join(root, 'nodes/generated', name)],
      bundle: true,
      write: false,
      format: 'iife',
      globalName: 'x',
    });
    return new Function(`${outputFiles[0]?.text}; return x;`)() as T;
  }

  const gen = () => main([], { root, version: '1' });

  test('a folder and an ISF file are in the registry, with their texts', async () => {
    await write({
      'nodes/value/twice/definition.ts': definitionFile('value/twice'),
      'nodes/value/twice/runtime.ts': 'export function create() { return "twice"; }\n',
      'nodes/layer/hide/definition.ts': definitionFile('layer/hide'),
      'nodes/layer/hide/hide.fs': 'void main() {}\n',
      'nodes/layer/hide/example/project.scrim.json': '{}',
      'shader-library/filters/negate.fs': FILTER,
      'shader-library/filters/README.md': 'not a shader',
    });
    expect(await gen()).toBe(0);

    const { DEFINITIONS, SHADERS } = await load<{ DEFINITIONS: NodeDefinition[]; SHADERS: Record<string, string> }>('definitions.gen.ts');
    expect(DEFINITIONS.map((definition) => definition.type)).toEqual(['layer/hide', 'value/twice', 'filter/negate']);
    expect(DEFINITIONS[2]).toMatchObject({
      doc: 'Turns black to white.',
      params: { amount: { type: 'number', default: 0.5, min: 0, max: 1 } },
      lowering: { kind: 'image', shader: 'filters/negate.fs', access: 'pointwise' },
    });
    const { 'fonts/inter': font = '', ...shaders } = SHADERS;
    expect(font).toContain('\nA\t');
    expect(shaders).toEqual({ 'filters/negate.fs': FILTER, 'layer/hide/hide.fs': 'void main() {}\n' });

    const { RUNTIMES } = await load<{ RUNTIMES: Record<string, { create(): string }> }>('runtimes.gen.ts');
    expect(Object.keys(RUNTIMES)).toEqual(['value/twice']);
    expect(RUNTIMES['value/twice']?.create()).toBe('twice');
    const { RUNTIME_FILES } = await load<{ RUNTIME_FILES: Record<string, string> }>('runtime-files.gen.ts');
    expect(RUNTIME_FILES).toEqual({ 'value/twice': 'nodes/value/twice/runtime.ts' });
  });

  test('a folder of recipes is in the registry, as texts of projects; a broken one fails with its name', async () => {
    const project = JSON.stringify({
      format: 'scrim-project',
      version: 1,
      title: 'Old photo',
      graphs: { main: { nodes: {}, wires: [] }, recipe: { nodes: { 'sepia-a1b2': { type: 'filter/sepia', version: 1 } }, wires: [] } },
      recipe: {},
    });
    await write({ 'shader-library/recipes/old-photo/project.scrim.json': project });
    expect(await gen()).toBe(0);
    expect(await load('recipes.gen.ts')).toEqual({ RECIPES: { 'old-photo': { project, layout: null } } });
    await write({ 'shader-library/recipes/broken/project.scrim.json': '{ "format": "scrim-project" }' });
    expect(await gen()).toBe(1);
    expect(errors.mock.calls[0]?.[0]).toMatch(/^shader-library\/recipes\/broken: project\.scrim\.json.*SCR00\d/);
  });

  test('what plays bound params is among the runtimes, and no node type', async () => {
    await write({
      'nodes/binding/track/runtime.ts': 'export function create() { return "track"; }\n',
      'nodes/binding/track/ease.ts': 'export const x = 1;\n',
    });
    expect(await gen()).toBe(0);
    expect((await load<{ DEFINITIONS: NodeDefinition[] }>('definitions.gen.ts')).DEFINITIONS).toEqual([]);
    const { RUNTIMES } = await load<{ RUNTIMES: Record<string, { create(): string }> }>('runtimes.gen.ts');
    expect(RUNTIMES['binding/track']?.create()).toBe('track');
    const { RUNTIME_FILES } = await load<{ RUNTIME_FILES: Record<string, string> }>('runtime-files.gen.ts');
    expect(RUNTIME_FILES).toEqual({ 'binding/track': 'nodes/binding/track/runtime.ts' });
  });

  test('a worker is among the runtimes as one text, which runs by itself; one that is gone leaves nothing behind', async () => {
    await write({
      'nodes/kit/serve-pixels.ts': await readFile('nodes/kit/serve-pixels.ts', 'utf8'),
      'nodes/filter/cpu-negate/definition.ts': definitionFile('filter/cpu-negate'),
      'nodes/filter/cpu-negate/worker.ts':
        'import { most } from "./most.ts";\nexport function process({ data }: { data: Uint8Array }) { data[0] = most - data[0]!; }\n',
      'nodes/filter/cpu-negate/most.ts': 'export const most = 255;\n',
    });
    expect(await gen()).toBe(0);
    const { RUNTIMES } = await load<{ RUNTIMES: Record<string, { worker: string }> }>('runtimes.gen.ts');
    const { RUNTIME_FILES } = await load<{ RUNTIME_FILES: Record<string, string> }>('runtime-files.gen.ts');
    const file = RUNTIME_FILES['filter/cpu-negate'] ?? '';
    expect(file).toBe('nodes/generated/workers/filter-cpu-negate.gen.ts');
    const answers: { buffer: ArrayBuffer; failure: string | null }[] = [];
    const scope: { onmessage?: (event: unknown) => void; postMessage: (answer: never) => void } = {
      postMessage: (answer) => answers.push(answer),
    };
    new Function('self', RUNTIMES['filter/cpu-negate']?.worker ?? '')(scope);
    scope.onmessage?.({ data: { view: 0, turn: 0, buffer: Uint8Array.of(55, 1, 2, 3).buffer, widthPx: 1, heightPx: 1, params: {} } });
    expect(answers[0]?.failure).toBe(null);
    expect([...new Uint8Array(answers[0]?.buffer ?? new ArrayBuffer(0))]).toEqual([200, 1, 2, 3]);
    await rm(join(root, 'nodes/filter'), { recursive: true });
    expect(await gen()).toBe(0);
    await expect(stat(join(root, file))).rejects.toThrow('ENOENT');
  });

  test('a worker that cannot be bundled fails with its file', async () => {
    await write({
      'nodes/kit/serve-pixels.ts': 'export function servePixels() {}\n',
      'nodes/filter/cpu-x/definition.ts': definitionFile('filter/cpu-x'),
      'nodes/filter/cpu-x/worker.ts': 'export function other() {}\n',
    });
    expect(await gen()).toBe(1);
    expect(errors.mock.calls[0]?.[0]).toMatch(/^nodes\/filter\/cpu-x\/worker\.ts: .*process/s);
  });

  test('nothing is written when nothing changed, and a changed shader is seen', async () => {
    await write({ 'shader-library/filters/negate.fs': FILTER });
    await gen();
    const path = join(root, 'nodes/generated/definitions.gen.ts');
    const { mtimeMs } = await stat(path);
    const text = await readFile(path, 'utf8');
    await gen();
    expect((await stat(path)).mtimeMs).toBe(mtimeMs);
    await write({ 'shader-library/filters/negate.fs': FILTER.replace('0.5', '0.25') });
    await gen();
    expect(await readFile(path, 'utf8')).toBe(
      text.replace('"default":0.5', '"default":0.25').replace('\\"DEFAULT\\": 0.5', '\\"DEFAULT\\": 0.25'),
    );
  });

  test('a broken header fails with its place, and the rest is still there', async () => {
    await write({
      'shader-library/filters/broken.fs': '/*{ "INPUTS": [ }*/\nvoid main() {}\n',
      'shader-library/filters/negate.fs': FILTER,
    });
    expect(await gen()).toBe(1);
    expect(errors.mock.calls[0]?.[0]).toMatch(/^filters\/broken\.fs:1:\d+: error SCR040: /);
    const { DEFINITIONS } = await load<{ DEFINITIONS: NodeDefinition[] }>('definitions.gen.ts');
    expect(DEFINITIONS.map((definition) => definition.type)).toEqual(['filter/negate']);
  });

  test('a file in the folder of another kind fails', async () => {
    await write({ 'shader-library/operators/negate.fs': FILTER });
    expect(await gen()).toBe(1);
    expect(errors.mock.calls).toEqual([[expect.stringContaining('it belongs into filters/')]]);
  });
});
