import { readFile } from 'node:fs/promises';
import type { Page } from 'playwright-core';
import { driverDiagnostics, uniqueDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import { companionOf } from '../../../export/glsl/isf/read-isf.ts';
import { tooManyRounds } from '../../../export/program/loop-budget.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { bundleScript } from '../../services/bundle-script.ts';
import type { Chromium } from '../../services/chromium.ts';
import { startBrowser } from '../../services/start-browser.ts';
import type * as DriverPage from './driver.page.ts';
import { type LinkedFile, linkFile } from './link-file.ts';

export interface CheckedFile {
  /** As the command line names it. */
  readonly path: string;
  readonly ok: boolean;
  readonly diagnostics: readonly Diagnostic[];
}

export interface CheckOptions {
  /** Holds Scrim's sources. */
  readonly root: string;
  readonly chromium: Chromium;
  readonly say: (text: string) => void;
  readonly interrupted: AbortSignal;
}

/** Shaders that the driver is given at once: enough for all its threads, few enough that progress shows. */
const BATCH = 32;

const PAGE_ENTRY = 'app/cli/shader/driver.page.ts';

/** Compiles shader files in the real driver, and runs their loops. Answers in the order of `paths`. */
export async function checkShaders(paths: readonly string[], options: CheckOptions): Promise<readonly CheckedFile[]> {
  const { root, chromium, say, interrupted } = options;
  say('Starting the browser…');
  const [script, browser] = await Promise.all([bundleScript(root, PAGE_ENTRY, 'scrimShaders'), startBrowser(chromium)]);
  try {
    const page = await browser.newPage();
    await page.addScriptTag({ content: script });
    const checked: CheckedFile[] = [];
    const read = (start: number) => Promise.all(paths.slice(start, start + BATCH).map(readShader));
    let next = read(0);
    for (let start = 0; start < paths.length; start += BATCH) {
      interrupted.throwIfAborted();
      if (paths.length > BATCH) say(`Compiling ${start + 1} of ${paths.length} shaders…`);
      const judged = judge(page, await next);
      // The driver has its own processes: meanwhile the next are read and linked.
      next = read(start + BATCH);
      checked.push(...(await judged));
    }
    return checked;
  } finally {
    await browser.close();
  }
}

type ReadFile = LinkedFile & { readonly vertex: string };

async function readShader(path: string): Promise<ReadFile> {
  const source = await readFile(path, 'utf8').catch((error: Error) => error);
  const companion = companionOf(path);
  const vertex = companion === path ? null : await readFile(companion, 'utf8').catch(() => null);
  if (typeof source === 'string') return { ...linkFile(source, path, vertex), vertex: vertex ?? '' };
  const unreadable: Diagnostic = { code: 'SCR004', severity: 'error', message: `The file cannot be read: ${source.message}.`, file: path };
  return { file: path, source: '', vertex: '', passes: [], diagnostics: [unreadable] };
}

async function judge(page: Page, files: readonly ReadFile[]): Promise<CheckedFile[]> {
  const jobs = files.flatMap(({ passes }) => passes.map(({ job }) => job));
  const verdicts = await page.evaluate(
    (all) => (globalThis as unknown as { scrimShaders: typeof DriverPage }).scrimShaders.judge(all),
    jobs,
  );
  let next = 0;
  return files.map((linked) => {
    const own = verdicts.slice(next, next + linked.passes.length);
    next += linked.passes.length;
    return checkedFile(linked, own);
  });
}

function checkedFile({ file, source, vertex, passes, diagnostics }: ReadFile, verdicts: readonly DriverPage.ShaderVerdict[]): CheckedFile {
  const said = passes.flatMap(({ shader }, i): Diagnostic[] => {
    const { logs = [], endlessLine = null } = verdicts[i] ?? {};
    const endless = endlessLine === null ? [] : [tooManyRounds(shader, endlessLine)];
    return [
      ...logs.flatMap(({ log, stage }) => driverDiagnostics(shader, log, (name) => (name === file ? source : vertex), stage)),
      ...endless,
    ];
  });
  // There is no node: the file alone says where.
  const all = uniqueDiagnostics([...diagnostics, ...said].map(({ nodeId: _, ...diagnostic }) => ({ file, ...diagnostic })));
  return { path: file, ok: !hasErrors(all), diagnostics: all };
}
