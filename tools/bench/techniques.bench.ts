import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import type { ProjectFiles } from '../../app/contract/contract.ts';
import { compileProject } from '../../app/services/compile-project.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import { listFiles } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';

const SIZE_PX = [640, 480] as const;
const FRAMES = 5;

/** Over everything in the first example; it would hide what objects cost. */
const MUTED = ['filter/color-temperature'];

/** A frame of the first example with each technique that ships, against the same with the objects' own materials. */
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
  const files = style(await readProjectFiles(folder), technique);
  const { program, diagnostics } = await compileProject(folder, files, () => ({ sourceMaps: false }));
  if (program === null) throw new Error(`The example does not compile with ${technique}: ${JSON.stringify(diagnostics)}`);
  const page = await openPage(browser, root, 'tools/bench/pages/scrim.page.ts', folder);
  await call(page, 'open', program, '', ...SIZE_PX);
  return page;
}

interface Document {
  readonly graphs: {
    readonly main: { readonly nodes: Record<string, { type: string; version?: number; muted?: boolean }>; wires: string[] };
  };
}

/** The project with the technique before whatever a scene draws. */
function style(files: ProjectFiles, technique: string | null): ProjectFiles {
  const document = JSON.parse(files.project) as Document;
  const { main } = document.graphs;
  for (const node of Object.values(main.nodes)) if (MUTED.includes(node.type)) node.muted = true;
  if (technique !== null) {
    const scene = Object.keys(main.nodes).find((id) => main.nodes[id]?.type === 'layer/scene');
    main.nodes['style-0000'] = { type: technique, version: 1 };
    main.nodes['apply-0000'] = { type: 'objects/apply-technique', version: 1 };
    main.wires = main.wires.map((wire) => wire.replace(`-> ${scene}.objects`, '-> apply-0000.objects'));
    main.wires.push('style-0000.technique -> apply-0000.technique', `apply-0000.objects -> ${scene}.objects`);
  }
  return { ...files, project: JSON.stringify(document) };
}
