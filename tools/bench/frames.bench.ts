import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import type { ProjectFiles } from '../../app/contract/contract.ts';
import { compileProject } from '../../app/services/compile-project.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, openPage, startBrowser } from './open-page.ts';

const SIZE_PX = [640, 480] as const;
const FRAMES = 10;

/** What a frame of the first example costs, against the same objects, light and shadow drawn by three.js alone. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  return [
    compare(root, 'frame, first-light', []),
    // Without the filter over everything, the layers are drawn straight onto the screen, as three.js does.
    compare(root, 'frame, first-light without its filter', ['filter/color-temperature']),
  ];
}

function compare(root: string, name: string, mutedTypes: readonly string[]): Bench {
  const folder = join(root, 'examples', 'first-light');
  let opened: Promise<{ browser: Browser; ours: Page; theirs: Page }> | undefined;
  const open = async () => {
    const { program } = await compileProject(folder, mute(await readProjectFiles(folder), mutedTypes), () => ({ sourceMaps: false }));
    if (program === null) throw new Error('The first example does not compile.');
    const browser = await startBrowser();
    const ours = await openPage(browser, root, 'tools/bench/pages/scrim.page.ts', folder);
    await call(ours, 'open', program, '', ...SIZE_PX);
    const theirs = await openPage(browser, root, 'tools/bench/pages/three.page.ts', folder);
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

function mute(files: ProjectFiles, types: readonly string[]): ProjectFiles {
  const document = JSON.parse(files.project) as { graphs: { main: { nodes: Record<string, { type: string; muted?: boolean }> } } };
  for (const node of Object.values(document.graphs.main.nodes)) if (types.includes(node.type)) node.muted = true;
  return { ...files, project: JSON.stringify(document) };
}
