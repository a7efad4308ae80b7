import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { compileProject } from '../../app/services/compile-project.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import { listFiles } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';

const SIZE_PX = [640, 480] as const;
const FRAMES = 3;

/** A frame of a large ball and its shadow on a floor, with each technique that ships, against the same with their own materials. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const files = await listFiles(join(root, 'shader-library', 'techniques'));
  return files.map((file) => against(root, file.replace('.glsl', '')));
}

function against(root: string, name: string): Bench {
  let opened: Promise<{ browser: Browser; styled: Page; own: Page }> | undefined;
  const open = async () => {
    const browser = await startBenchBrowser();
    const own = await openStyled(browser, root, null);
    const styled = await openStyled(browser, root, `technique/${name}`);
    return { browser, styled, own };
  };
  return {
    name: `frame, technique ${name}, against own materials`,
    unit: 'ratio',
    sample: async () => {
      opened ??= open();
      const { styled, own } = await opened;
      return (await call<number>(styled, 'frameMs', FRAMES)) / (await call<number>(own, 'frameMs', FRAMES));
    },
    dispose: async () => (await opened)?.browser.close(),
  };
}

async function openStyled(browser: Browser, root: string, technique: string | null): Promise<Page> {
  const folder = join(root, 'examples', 'first-light');
  const files = { ...(await readProjectFiles(folder)), project: JSON.stringify(ballProject(technique)) };
  const { program, diagnostics } = await compileProject(folder, files, () => ({ sourceMaps: false }));
  if (program === null) throw new Error(`The ball does not compile with ${technique}: ${JSON.stringify(diagnostics)}`);
  const page = await openPage(browser, root, 'tools/bench/pages/scrim.page.ts', folder);
  await call(page, 'open', program, '', ...SIZE_PX);
  return page;
}

function ballProject(technique: string | null): object {
  const styled = technique === null ? 'every-0000' : 'apply-0000';
  return {
    format: 'scrim-project',
    version: 1,
    title: 'A ball',
    graphs: {
      main: {
        nodes: {
          'ball-0000': { type: 'objects/primitive', version: 1, params: { shape: 'sphere', sizeM: [1.6, 1.6, 1.6] } },
          'floor-0000': { type: 'objects/primitive', version: 1, params: { shape: 'plane', sizeM: [5, 0, 5] } },
          'every-0000': { type: 'objects/group', version: 1 },
          'sun-0000': { type: 'light/directional', version: 1 },
          'scene-0000': { type: 'layer/scene', version: 1 },
          'screen-0000': { type: 'output/screen', version: 1 },
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
          'scene-0000.layer -> screen-0000.layer',
        ],
      },
    },
  };
}
