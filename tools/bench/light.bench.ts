import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { compileProject } from '../../app/services/compile-project.ts';
import { listFiles } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';
import type { LitLayer } from './pages/three-light.page.ts';

const SIZE_PX = [640, 480] as const;
/** Frames per sample and page. The two pages draw alternately. */
const FRAMES = 4;
const SAMPLES = 5;
const WARM_FRAMES = 3;
const NAME = 'frame, ball under a panorama and a sun';

interface Pages {
  readonly browser: Browser;
  readonly ours: Page;
  readonly theirs: Readonly<Record<LitLayer, Page>>;
}

/**
 * Compares frames with three.js alone: a ball and a floor in the light of a panorama and a sun with shadow, with their own materials, as a
 * scene layer with a Tone map, and with each technique.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const folder = join(root, 'nodes', 'source', 'panorama', 'example');
  const techniques = (await listFiles(join(root, 'shader-library', 'techniques'))).map((file) => file.replace('.glsl', ''));
  const rows = [
    { suffix: '', project: litProject(null, 'display'), against: 'display' as const },
    { suffix: ', scene layer and Tone map', project: litProject(null, 'scene'), against: 'scene' as const },
    ...techniques.map((name) => ({
      suffix: `, technique ${name}`,
      project: litProject(`technique/${name}`, 'display'),
      against: 'display' as const,
    })),
  ];
  let opened: Promise<Pages> | undefined;
  let shown: object | undefined;
  let left = rows.length;

  const compiled = async (project: object) => {
    const files = { project: JSON.stringify(project), layout: null, sources: {} };
    const { program, diagnostics } = await compileProject(folder, files, () => ({ sourceMaps: false }));
    if (program === null) throw new Error(`What is to be measured does not compile: ${JSON.stringify(diagnostics)}`);
    return program;
  };
  const open = async (): Promise<Pages> => {
    const browser = await startBenchBrowser();
    const three = async (layer: LitLayer) => {
      const page = await openPage(browser, root, 'tools/bench/pages/three-light.page.ts', folder);
      await call(page, 'open', 'assets/sky.hdr', ...SIZE_PX, layer);
      await call(page, 'frameMs', WARM_FRAMES);
      return page;
    };
    const ours = await openPage(browser, root, 'tools/bench/pages/scrim.page.ts', folder);
    await call(ours, 'open', await compiled(litProject(null, 'display')), '', ...SIZE_PX);
    return { browser, ours, theirs: { display: await three('display'), scene: await three('scene') } };
  };
  return rows.map(({ suffix, project, against }) => ({
    name: `${NAME}${suffix}, against three.js alone`,
    unit: 'ratio' as const,
    samples: SAMPLES,
    sample: async () => {
      opened ??= open();
      const { ours, theirs } = await opened;
      if (shown !== project) {
        await call(ours, 'show', await compiled(project));
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
      if (left === 0) await (await opened)?.browser.close();
    },
  }));
}

function litProject(technique: string | null, encoding: LitLayer): object {
  const styled = technique === null ? 'every-0000' : 'apply-0000';
  const last = encoding === 'scene' ? 'map-0000' : 'scene-0000';
  return {
    format: 'scrim-project',
    version: 1,
    title: 'A ball under a sky',
    graphs: {
      main: {
        nodes: {
          'ball-0000': { type: 'objects/primitive', version: 1, params: { shape: 'sphere', sizeM: [1.6, 1.6, 1.6] } },
          'floor-0000': { type: 'objects/primitive', version: 1, params: { shape: 'plane', sizeM: [5, 0, 5] } },
          'every-0000': { type: 'objects/group', version: 1 },
          'sun-0000': { type: 'light/directional', version: 1 },
          'sky-0000': { type: 'source/panorama', version: 1, params: { file: 'sky' } },
          'around-0000': { type: 'light/environment', version: 1 },
          'scene-0000': { type: 'layer/scene', version: 1, params: { encoding } },
          'screen-0000': { type: 'output/screen', version: 1 },
          ...(encoding === 'scene' && { 'map-0000': { type: 'filter/tone-map', version: 1 } }),
          ...(technique !== null && {
            'style-0000': { type: technique, version: 1 },
            'apply-0000': { type: 'objects/apply-technique', version: 1 },
          }),
        },
        wires: [
          'ball-0000.objects -> every-0000.objects',
          'floor-0000.objects -> every-0000.objects',
          ...(technique === null ? [] : ['every-0000.objects -> apply-0000.objects', 'style-0000.technique -> apply-0000.technique']),
          `${styled}.objects -> scene-0000.objects`,
          'sun-0000.lights -> scene-0000.lights',
          'sky-0000.environment -> around-0000.environment',
          'around-0000.lights -> scene-0000.lights',
          ...(encoding === 'scene' ? ['scene-0000.layer -> map-0000.inputImage'] : []),
          `${last}.layer -> screen-0000.layer`,
        ],
      },
    },
    assets: { sky: { path: 'assets/sky.hdr', kind: 'environment' } },
  };
}
