import { copyFile, mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { listFiles } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { compiledProgram } from './compiled-program.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';
import type { LitLayer } from './pages/three-light.page.ts';

const SIZE_PX = [640, 480] as const;
/** Frames per sample and page. The two pages draw alternately. */
const FRAMES = 4;
const SAMPLES = 5;
const WARM_FRAMES = 3;
const NAME = 'frame, ball under a panorama and a sun';

/** Of the ball of glass, by the names of three.js. */
const GLASS = { color: 0xffffff, roughness: 0.1, metalness: 0, transmission: 1, thickness: 0.8, ior: 1.5 } as const;

type Rival = LitLayer | 'glass';

interface Pages {
  readonly browser: Browser;
  readonly ours: Page;
  readonly theirs: Readonly<Record<Rival, Page>>;
  readonly folder: string;
}

/**
 * Compares frames with three.js alone: a ball and a floor in the light of a panorama and a sun with shadow, with their own materials, as a
 * scene layer with a Tone map, with each technique, and with a ball of glass, which three.js draws by its own transmission.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const techniques = (await listFiles(join(root, 'shader-library', 'techniques'))).map((file) => file.replace('.glsl', ''));
  const rows: readonly { readonly suffix: string; readonly project: object; readonly against: Rival }[] = [
    { suffix: '', project: litProject(), against: 'display' },
    { suffix: ', scene layer and Tone map', project: litProject({ encoding: 'scene' }), against: 'scene' },
    { suffix: ', of glass', project: litProject({ isModel: true }), against: 'glass' },
    { suffix: ', of glass by the technique', project: litProject({ technique: 'technique/glass', isBallAlone: true }), against: 'glass' },
    ...techniques.map(
      (name) => ({ suffix: `, technique ${name}`, project: litProject({ technique: `technique/${name}` }), against: 'display' }) as const,
    ),
  ];
  let opened: Promise<Pages> | undefined;
  let shown: object | undefined;
  let left = rows.length;

  const compiled = (folder: string, project: object) =>
    compiledProgram(folder, { project: JSON.stringify(project), layout: null, sources: {} });
  const open = async (): Promise<Pages> => {
    const folder = await prepareFolder(root);
    const browser = await startBenchBrowser();
    const three = async (layer: LitLayer, glass: object | null = null) => {
      const page = await openPage(browser, root, 'tools/bench/pages/three-light.page.ts', folder);
      await call(page, 'open', 'assets/sky.hdr', ...SIZE_PX, layer, glass);
      await call(page, 'frameMs', WARM_FRAMES);
      return page;
    };
    const glass = await three('display', GLASS);
    await writeFile(join(folder, 'assets', 'ball.glb'), Uint8Array.from(await call<number[]>(glass, 'ballAsModel')));
    const ours = await openPage(browser, root, 'tools/bench/pages/scrim.page.ts', folder);
    await call(ours, 'open', await compiled(folder, litProject()), '', ...SIZE_PX);
    return { browser, ours, theirs: { display: await three('display'), scene: await three('scene'), glass }, folder };
  };
  return rows.map(({ suffix, project, against }) => ({
    name: `${NAME}${suffix}, against three.js alone`,
    unit: 'ratio' as const,
    samples: SAMPLES,
    sample: async () => {
      opened ??= open();
      const { ours, theirs, folder } = await opened;
      if (shown !== project) {
        await call(ours, 'show', await compiled(folder, project));
        await call(ours, 'frameMs', WARM_FRAMES);
      }
      shown = project;
      const sums = { ours: 0, theirs: 0 };
      // Alternately, so that other load of the machine affects both equally.
      for (let i = 0; i < FRAMES; i++) {
        sums.ours += await call<number>(ours, 'frameMs', 1);
        sums.theirs += await call<number>(theirs[against], 'frameMs', 1);
      }
      return sums.ours / sums.theirs;
    },
    dispose: async () => {
      left--;
      if (left > 0 || !opened) return;
      const { browser, folder } = await opened;
      await browser.close();
      await rm(folder, { recursive: true });
    },
  }));
}

/** A folder with the panorama. */
async function prepareFolder(root: string): Promise<string> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
  await mkdir(join(folder, 'assets'));
  await copyFile(join(root, 'nodes', 'source', 'panorama', 'example', 'assets', 'sky.hdr'), join(folder, 'assets', 'sky.hdr'));
  return folder;
}

interface Lit {
  readonly technique?: string;
  readonly encoding?: LitLayer;
  /** Whether the technique leaves out the floor. */
  readonly isBallAlone?: boolean;
  /** Whether the ball is that of glass. */
  readonly isModel?: boolean;
}

function litProject({ technique, encoding = 'display', isBallAlone = false, isModel = false }: Lit = {}): object {
  const styled = technique === undefined || isBallAlone ? 'every-0000' : 'apply-0000';
  const last = encoding === 'scene' ? 'map-0000' : 'scene-0000';
  return {
    format: 'scrim-project',
    version: 1,
    title: 'A ball under a sky',
    graphs: {
      main: {
        nodes: {
          'ball-0000': isModel
            ? { type: 'source/model', version: 1, params: { model: 'ball' } }
            : { type: 'objects/primitive', version: 1, params: { shape: 'sphere', sizeM: [1.6, 1.6, 1.6] } },
          'floor-0000': { type: 'objects/primitive', version: 1, params: { shape: 'plane', sizeM: [5, 0, 5] } },
          'every-0000': { type: 'objects/group', version: 1 },
          'sun-0000': { type: 'light/directional', version: 1 },
          'sky-0000': { type: 'source/panorama', version: 1, params: { file: 'sky' } },
          'around-0000': { type: 'light/environment', version: 1 },
          'scene-0000': { type: 'layer/scene', version: 1, params: { encoding } },
          'screen-0000': { type: 'output/screen', version: 1 },
          ...(encoding === 'scene' && { 'map-0000': { type: 'filter/tone-map', version: 1 } }),
          ...(technique !== undefined && {
            'style-0000': { type: technique, version: 1 },
            'apply-0000': { type: 'objects/apply-technique', version: 1 },
          }),
        },
        wires: [
          isBallAlone ? 'apply-0000.objects -> every-0000.objects' : 'ball-0000.objects -> every-0000.objects',
          'floor-0000.objects -> every-0000.objects',
          ...(technique === undefined
            ? []
            : [`${isBallAlone ? 'ball' : 'every'}-0000.objects -> apply-0000.objects`, 'style-0000.technique -> apply-0000.technique']),
          `${styled}.objects -> scene-0000.objects`,
          'sun-0000.lights -> scene-0000.lights',
          'sky-0000.environment -> around-0000.environment',
          'around-0000.lights -> scene-0000.lights',
          ...(encoding === 'scene' ? ['scene-0000.layer -> map-0000.inputImage'] : []),
          `${last}.layer -> screen-0000.layer`,
        ],
      },
    },
    assets: {
      sky: { path: 'assets/sky.hdr', kind: 'environment' },
      ...(isModel && { ball: { path: 'assets/ball.glb', kind: 'model' } }),
    },
  };
}
