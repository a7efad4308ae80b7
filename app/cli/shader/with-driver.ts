import { driverDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import { tooManyRounds } from '../../../export/program/loop-budget.ts';
import type { LinkedShader } from '../../../export/program/program.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { bundleScript } from '../../services/bundle-script.ts';
import type { Chromium } from '../../services/chromium.ts';
import { startBrowser } from '../../services/start-browser.ts';
import type * as DriverPage from './driver.page.ts';

export interface DriverOptions {
  /** Holds Scrim's sources. */
  readonly root: string;
  readonly chromium: Chromium;
  readonly say: (text: string) => void;
}

/** Compiles shaders in the real driver, and runs their loops. Answers in their order. */
export type Judge = (jobs: readonly DriverPage.ShaderJob[]) => Promise<readonly DriverPage.ShaderVerdict[]>;

const PAGE_ENTRY = 'app/cli/shader/driver.page.ts';

/** Lends a graphics driver, by way of a headless browser, for as long as `use` takes. */
export async function withDriver<T>({ root, chromium, say }: DriverOptions, use: (judge: Judge) => Promise<T>): Promise<T> {
  say('Starting the browser…');
  const [script, browser] = await Promise.all([bundleScript(root, PAGE_ENTRY, 'scrimShaders'), startBrowser(chromium)]);
  try {
    const page = await browser.newPage();
    await page.addScriptTag({ content: script });
    return await use((jobs) =>
      page.evaluate((all) => (globalThis as unknown as { scrimShaders: typeof DriverPage }).scrimShaders.judge(all), jobs),
    );
  } finally {
    await browser.close();
  }
}

/** What the driver said of one shader, on its author's lines. */
export function verdictDiagnostics(
  shader: LinkedShader,
  { logs, endlessLine }: DriverPage.ShaderVerdict = { logs: [], endlessLine: null },
  sourceOf?: (file: string) => string | undefined,
): Diagnostic[] {
  const endless = endlessLine === null ? [] : [tooManyRounds(shader, endlessLine)];
  return [...logs.flatMap(({ log, stage }) => driverDiagnostics(shader, log, sourceOf, stage)), ...endless];
}
