import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import type { ProjectFiles } from '../../app/contract/contract.ts';
import { compileProject } from '../../app/services/compile-project.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';

const SIZE_PX = [640, 480] as const;
const FRAMES = 10;

/** What frames cost, and those of the first example against the same objects, light and shadow drawn by three.js alone. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  return [
    time(root, 'first-light'),
    time(root, 'gallery'),
    compare(root, 'frame, first-light', []),
    // Without the filter over everything, the layers are drawn straight onto the screen, as three.js does.
    compare(root, 'frame, first-light without its filter', ['filter/color-temperature']),
  ];
}

function time(root: string, example: string): Bench {
  let opened: Promise<{ browser: Browser; page: Page }> | undefined;
  const open = async () => {
    const browser = await startBenchBrowser();
    return { browser, page: await openExample(browser, root, example, []) };
  };
  return {
    name: `frame, ${example}`,
    unit: 'ms',
    sample: async () => {
      opened ??= open();
      return call<number>((await opened).page, 'frameMs', FRAMES);
    },
    dispose: async () => (await opened)?.browser.close(),
  };
}

function compare(root: string, name: string, mutedTypes: readonly string[]): Bench {
  let opened: Promise<{ browser: Browser; ours: Page; theirs: Page }> | undefined;
  const open = async () => {
    const browser = await startBenchBrowser();
    const ours = await openExample(browser, root, 'first-light', mutedTypes);
    const theirs = await openPage(browser, root, 'tools/bench/pages/three.page.ts', join(root, 'examples', 'first-light'));
    await call(theirs, 'open', 'assets/robot.glb', ...SIZE_PX);
    return { browser, ours, theirs };
  };
  return {
    name: `${name}, against three.js alone`,
    unit: 'ratio',
    sample: async () => {
      opened ??= open();
      const { ours, theirs } = await opened;
      return (await call<number>(ours, 'frameMs', FRAMES)) / (await call<number>(theirs, 'frameMs', FRAMES));
    },
    dispose: async () => (await opened)?.browser.close(),
  };
}

async function openExample(browser: Browser, root: string, example: string, mutedTypes: readonly string[]): Promise<Page> {
  const folder = join(root, 'examples', example);
  const { program } = await compileProject(folder, mute(await readProjectFiles(folder), mutedTypes), () => ({ sourceMaps: false }));
  if (program === null) throw new Error(`The example ${example} does not compile.`);
  const page = await openPage(browser, root, 'tools/bench/pages/scrim.page.ts', folder);
  await call(page, 'open', program, '', ...SIZE_PX);
  return page;
}

function mute(files: ProjectFiles, types: readonly string[]): ProjectFiles {
  const document = JSON.parse(files.project) as { graphs: { main: { nodes: Record<string, { type: string; muted?: boolean }> } } };
  for (const node of Object.values(document.graphs.main.nodes)) if (types.includes(node.type)) node.muted = true;
  return { ...files, project: JSON.stringify(document) };
}
