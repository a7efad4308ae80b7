import { createHash } from 'node:crypto';
import { resolve } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { captureMeshFile, meshCounts } from '../../nodes/kit/capture.ts';
import { packGlb } from '../gltf/pack-glb.ts';
import { PROGRAM_VERSION, type Program } from '../program/program.ts';
import { sessionInit } from '../runtime/sessions/webxr/session-init.ts';
import { type BundleInput, bundlePage } from './bundle-page.ts';
import type { ExportReport } from './report.ts';

const ROOT = resolve(import.meta.dirname, '../..');

const VERTEX = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }`;
const FRAGMENT = `#version 300 es
precision highp float;
out vec4 color;
void main() { color = vec4(1.0, 0.5, 0.0, 1.0); }`;

const PICTURE = new Uint8Array([1, 2, 3, 4]);
const MODEL = packGlb({ document: { asset: { version: '2.0' }, scenes: [{}] }, binary: null }, new Map());

/** One pass onto the screen, no objects: what a page of filters alone is. */
const IMAGE_ONLY: Program = {
  format: 'scrim-program',
  version: PROGRAM_VERSION,
  title: 'Orange & <friends>',
  slots: { numbers: [], texts: [], slots: [], params: {} },
  resources: [{ id: 'picture-a1.out', kind: 'external', domain: 'image' }],
  operations: [
    {
      id: 'picture-a1',
      node: 'picture-a1',
      kind: 'source',
      type: 'source/image-file',
      view: 'once',
      reads: [],
      writes: ['picture-a1.out'],
      inputs: {},
      multiple: [],
      outputs: {},
      params: {},
      config: {},
      assets: { file: 'picture' },
    },
    {
      id: 'flat-b2',
      node: 'flat-b2',
      kind: 'pass',
      view: 'each',
      reads: [],
      writes: [],
      shader: 0,
      target: 'screen',
      blend: 'replace',
      samplers: [],
      uniforms: [],
      passIndex: 0,
    },
  ],
  shaders: [
    {
      id: 'flat',
      vertex: VERTEX,
      fragment: FRAGMENT,
      sourceMap: { sources: ['filters/secret-source-name.fs'], nodes: ['flat-b2'], lines: [] },
    },
  ],
  assets: [
    { id: 'picture', kind: 'image', path: 'assets/my picture.png' },
    { id: 'unused', kind: 'model', path: 'assets/unused.glb' },
  ],
  presentation: { mode: 'composed', antialias: false, background: 'world', blend: 'alpha' },
  needs: [
    { capability: 'depth', required: false, nodes: ['a-1'], why: 'to hide things', without: 'nothing is hidden' },
    { capability: 'camera-image', required: true, nodes: ['b-1'], why: 'to tint it', without: 'nothing' },
  ],
  tiers: [
    { id: 'ar-camera', without: [] },
    { id: 'orbit', without: [] },
  ],
  taps: { 'flat-b2.out': { color: 'picture-a1.out', depth: null } },
};

const WITH_OBJECTS: Program = {
  ...IMAGE_ONLY,
  operations: [
    ...IMAGE_ONLY.operations,
    {
      id: 'robot-c3',
      node: 'robot-c3',
      kind: 'geometry',
      type: 'source/model',
      view: 'once',
      reads: [],
      writes: [],
      inputs: {},
      multiple: [],
      outputs: {},
      params: {},
      config: {},
      assets: { file: 'unused' },
    },
  ],
};

async function exported(program: Program, more: Partial<BundleInput> = {}) {
  const files = new Map<string, Uint8Array>();
  const { output, diagnostics } = await bundlePage({
    program,
    page: { description: 'A page "of" tests', language: 'de' },
    generator: 'Scrim 0.0.0',
    root: ROOT,
    readAsset: async (path) => (path.endsWith('.glb') ? MODEL : PICTURE),
    sink: {
      write: async (path, bytes) => {
        expect(files.has(path)).toBe(false);
        files.set(path, bytes);
      },
    },
    ...more,
  });
  const text = (pattern: RegExp) => {
    const path = [...files.keys()].find((name) => pattern.test(name));
    return new TextDecoder().decode(path === undefined ? undefined : files.get(path));
  };
  return { files, output, diagnostics, text };
}

/** Words that only the editor, the compiler or the tests have; the names of packages as their own code spells them. */
const NEVER = [
  'react',
  'electron',
  'zustand',
  'monaco',
  'glsl-parser',
  'shaderfrog',
  'iwer',
  'immersive-web-emulation',
  'emulator',
  'zod',
  'ZodError',
  'jsonc',
  'immer',
  'xyflow',
  'esbuild',
  'playwright',
];

describe('a bundled page', () => {
  test('of image passes holds the player, its nodes, and no three.js', async () => {
    const { output, text } = await exported(IMAGE_ONLY);
    const script = text(/^page-.*\.js$/);
    for (const word of NEVER) expect([word, new RegExp(`\\b${word}\\b`, 'i').test(script)]).toEqual([word, false]);
    expect(script).not.toMatch(/THREE|WebGLRenderer|GLTFLoader|BufferGeometry/);
    const parts = Object.keys((output as ExportReport).script);
    const sessions = ['sessions.ts'];
    const expected = ['export/page', 'export/program', 'export/runtime', 'nodes/kit', 'nodes/source/image-file', 'page.ts', ...sessions];
    expect(parts.filter((part) => !expected.includes(part))).toEqual([]);
    expect(script.length).toBeLessThan(75_000);
    expect(script).not.toMatch(/selectstart|requestHitTestSource/);
    // What its program does not use: videos, sound, workers, controls, pulses, files in the page.
    expect(script).not.toMatch(/createElement\("video"\)|decodeAudioData|postMessage|type:"range"|x-scrim-file/);
  });

  test('has the sessions that a visitor enters in an own script, and a single-file page in the page itself', async () => {
    const { files, text } = await exported(IMAGE_ONLY);
    const path = [...files.keys()].find((name) => /^sessions-.*\.js$/.test(name));
    expect(text(/^page-.*\.js$/)).not.toMatch(/requestSession|getUserMedia\(|XRWebGLLayer/);
    expect(text(/^sessions-.*\.js$/)).toMatch(/requestSession.*XRWebGLLayer|XRWebGLLayer.*requestSession/s);
    expect(text(/^index\.html$/)).toContain(`"sessions":"${path}"`);
    expect(text(/^offline\.js$/)).toContain(`"${path}"`);
    const online = await exported(IMAGE_ONLY, { offline: false });
    expect([...online.files.keys()].sort()).toEqual([...files.keys()].filter((name) => name !== 'offline.js').sort());
    expect(online.text(/^index\.html$/)).toContain('"offline":null');
    const alone = await exported(IMAGE_ONLY, { singleFile: true });
    expect(alone.text(/^index\.html$/)).toContain('"sessions":null');
    expect(alone.text(/^index\.html$/)).toMatch(/requestSession/);
  });

  test('with objects holds three.js and the nodes in use, no others', async () => {
    const { output, text } = await exported(WITH_OBJECTS);
    const script = text(/^page-.*\.js$/);
    for (const word of NEVER) expect([word, new RegExp(`\\b${word}\\b`, 'i').test(script)]).toEqual([word, false]);
    const { script: parts, bytes } = output as ExportReport;
    expect(parts.three).toBeGreaterThan(300_000);
    const expected = [
      'export/gltf',
      'export/page',
      'export/program',
      'export/runtime',
      'nodes/kit',
      'nodes/source/image-file',
      'nodes/source/model',
      'page.ts',
      'sessions.ts',
      'three',
    ];
    expect(Object.keys(parts).filter((part) => !expected.includes(part))).toEqual([]);
    expect(Object.keys(parts)).toEqual(expect.arrayContaining(['nodes/source/image-file', 'nodes/source/model']));
    expect(Object.values(parts).reduce((sum, n) => sum + n, 0)).toBeLessThanOrEqual(bytes.byKind.script?.raw ?? 0);
  });

  test('has used assets alone, under names of their content, and no trace of the editor', async () => {
    const { files, text } = await exported(IMAGE_ONLY);
    const hash = createHash('sha256').update(PICTURE).digest('hex').slice(0, 10);
    expect([...files.keys()].filter((path) => path.startsWith('assets/'))).toEqual([`assets/my-picture-${hash}.png`]);
    const program = JSON.parse(text(/^program-.*\.json$/)) as Program;
    expect(program.assets).toEqual([{ id: 'picture', kind: 'image', path: `assets/my-picture-${hash}.png` }]);
    expect(program.taps).toEqual({});
    expect(text(/^program-.*\.json$/)).not.toContain('secret-source-name');
  });

  test('is found by relative addresses, under a strict policy, with title, description and language', async () => {
    const { text, files } = await exported(IMAGE_ONLY);
    const html = text(/^index\.html$/);
    expect(html).toContain('<html lang="de">');
    expect(html).toContain('<title>Orange &#38; &#60;friends&#62;</title>');
    expect(html).toContain('content="A page &#34;of&#34; tests"');
    expect(html).toMatch(/content-security-policy" content="default-src 'none'; script-src 'self';/);
    expect(html).not.toMatch(/unsafe|https?:|<script>|style="/);
    const addresses = [...html.matchAll(/(?:src|href)="([^"]*)"/g)]
      .map((match) => match[1] as string)
      .filter((a) => !a.startsWith('data:'));
    expect(addresses.length).toBeGreaterThanOrEqual(3);
    for (const address of addresses) expect([address, files.has(address)]).toEqual([address, true]);
  });

  test('loads small models and images beside its script, and large ones after it', async () => {
    const preloads = async (readAsset: BundleInput['readAsset']) => {
      const { files } = await exported(WITH_OBJECTS, { readAsset, compress: false });
      const html = new TextDecoder().decode(files.get('index.html'));
      return [...html.matchAll(/<link rel="preload" href="([^"]+)-\w+\.(\w+)" as="fetch" crossorigin>/g)].map(
        ([, name, type]) => `${name}.${type}`,
      );
    };
    const small = async (path: string) => (path.endsWith('.glb') ? MODEL : PICTURE);
    expect((await preloads(small)).sort()).toEqual(['assets/my-picture.png', 'assets/unused.glb', 'program.json']);
    const large = async (path: string) => (path.endsWith('.glb') ? MODEL : Uint8Array.from({ length: 600_000 }, (_, i) => PICTURE[i] ?? 0));
    expect(await preloads(large)).toEqual(['program.json']);
  });

  test('is the same to the byte when it is made twice', async () => {
    const [first, second] = [await exported(WITH_OBJECTS), await exported(WITH_OBJECTS)];
    expect([...second.files.keys()]).toEqual([...first.files.keys()]);
    for (const [path, bytes] of first.files)
      expect([path, Buffer.compare(bytes, second.files.get(path) ?? new Uint8Array())]).toEqual([path, 0]);
  });

  test('is reported: every file with its bytes, and the WebXR features that entering asks for', async () => {
    const { files, output, text } = await exported(IMAGE_ONLY);
    const report = JSON.parse(text(/^report\.json$/)) as ExportReport;
    expect(report).toEqual(output);
    expect(report.files.map(({ path }) => path)).toEqual([...files.keys()].filter((path) => path !== 'report.json').sort());
    for (const { path, raw } of report.files) expect(raw).toBe(files.get(path)?.length);
    expect(report.bytes.raw).toBe(report.files.reduce((sum, { raw }) => sum + raw, 0));
    const asked = sessionInit(IMAGE_ONLY.needs, null);
    expect(report.features).toEqual({ required: asked.requiredFeatures, optional: asked.optionalFeatures });
  });

  test('names whose works it is made of, and warns of terms that forbid business', async () => {
    const works: Program['credits'] = [
      { title: 'Waves', kind: 'effect', credit: 'Ada', licence: 'CC BY-NC-SA 3.0', nodes: ['waves-a', 'waves-b'] },
      { title: 'assets/my picture.png', kind: 'asset', credit: 'Bob', licence: 'CC BY 4.0', nodes: ['picture-a1'] },
    ];
    const model = packGlb({ document: { asset: { version: '2.0', copyright: '© Cy' }, scenes: [{}] }, binary: null }, new Map());
    const readAsset = async (path: string) => (path.endsWith('.glb') ? model : PICTURE);
    const page = await exported({ ...WITH_OBJECTS, credits: works }, { readAsset });
    const credits = [
      { title: 'Waves', kind: 'effect', credit: 'Ada', licence: 'CC BY-NC-SA 3.0' },
      { title: 'assets/my picture.png', kind: 'asset', credit: 'Bob', licence: 'CC BY 4.0' },
      { title: 'assets/unused.glb', kind: 'asset', credit: '© Cy', licence: '' },
    ];
    expect(page.output?.credits).toEqual(credits);
    const text = page.text(/^LICENSES\.txt$/);
    for (const word of ['Waves\n  Credit: Ada\n  License: CC BY-NC-SA 3.0', 'my picture.png\n  Credit: Bob', 'unused.glb\n  Credit: © Cy'])
      expect(text).toContain(word);
    expect(page.text(/^program-.*\.json$/)).not.toContain('Ada');
    expect(page.diagnostics).toMatchObject([{ code: 'SCR046', severity: 'warning', nodeId: 'waves-a' }]);
    expect(page.diagnostics[0]?.message).toContain('CC BY-NC-SA 3.0');
    const alone = await exported({ ...WITH_OBJECTS, credits: works }, { readAsset, singleFile: true });
    expect([...alone.files.keys()]).toEqual(['index.html', 'report.json']);
    expect(alone.output?.credits).toEqual(credits);
  });

  test('is not begun when an asset cannot be read', async () => {
    const readAsset = () => Promise.reject(new Error('there is no such file'));
    const drawPoster = () => Promise.reject(new Error('drawn without need'));
    const { files, output, diagnostics } = await exported(IMAGE_ONLY, { readAsset, drawPoster });
    expect(output).toBeNull();
    expect(files.size).toBe(0);
    expect(diagnostics).toMatchObject([{ code: 'SCR030', file: 'assets/my picture.png' }]);
  });

  test('of one file is refused with a capture of more than 20 MB', async () => {
    const mesh = { positions: Float32Array.of(0, 0, -1, 1, 0, -1, 0, 1, -1), indices: Uint32Array.of(0, 1, 2) };
    const worldFromCamera = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    const view = { file: '0.jpg', widthPx: 8, heightPx: 6, fxPx: 8, fyPx: 8, cxPx: 4, cyPx: 3, worldFromCamera };
    const document = { format: 'scrim-capture', version: 1, mesh: { file: 'mesh.bin', ...meshCounts(mesh) }, views: [view] };
    const path = 'assets/place.capture/capture.json';
    const files: Readonly<Record<string, Uint8Array>> = {
      [path]: Buffer.from(JSON.stringify(document)),
      'assets/place.capture/mesh.bin': captureMeshFile(mesh),
      'assets/place.capture/0.jpg': Buffer.alloc(21 * 2 ** 20),
    };
    const program: Program = { ...WITH_OBJECTS, assets: [{ id: 'unused', kind: 'capture', path }] };
    const readAsset = async (name: string) => files[name] ?? PICTURE;
    const drawPoster = () => Promise.reject(new Error('drawn without need'));
    const refused = await exported(program, { readAsset, drawPoster, singleFile: true });
    expect([refused.output, refused.files.size]).toEqual([null, 0]);
    const message = `${path} has 21 MB; a page of one file may contain captures of 20 MB.`;
    expect(refused.diagnostics).toMatchObject([{ code: 'SCR034', severity: 'error', message, file: path }]);
    expect((await exported(program, { readAsset })).diagnostics).toEqual([]);
  });

  test('is not begun when Scrim’s own sources cannot be bundled', async () => {
    const { files, output, diagnostics } = await exported(IMAGE_ONLY, { root: '/nowhere' });
    expect(output).toBeNull();
    expect(files.size).toBe(0);
    expect(diagnostics).toMatchObject([{ code: 'SCR064' }]);
  });
});
