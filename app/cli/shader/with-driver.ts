import type { Browser, Page } from 'playwright-core';
import { driverDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import { tooManyIterations } from '../../../export/program/loop-budget.ts';
import type { LinkedShader } from '../../../export/program/program.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { bundleScript } from '../../services/bundle-script.ts';
import type { Chromium } from '../../services/chromium.ts';
import { startBrowser } from '../../services/start-browser.ts';
import type * as DriverPage from './driver.page.ts';

export interface DriverOptions {
  /** Folder with the sources of Scrim. */
  readonly root: string;
  readonly chromium: Chromium;
  readonly say: (text: string) => void;
}

/**
 * Compiles shaders with the driver and runs their loops. Returns results in order; null if that takes longer than `limitS` (default:
 * no limit). The driver is then terminated, and the next call starts a new one.
 */
export interface Judge {
  (jobs: readonly DriverPage.ShaderJob[]): Promise<readonly DriverPage.ShaderVerdict[]>;
  (jobs: readonly DriverPage.ShaderJob[], limitS: number): Promise<readonly DriverPage.ShaderVerdict[] | null>;
}

const PAGE_ENTRY = 'app/cli/shader/driver.page.ts';

/** Starts a graphics driver in a headless browser, and ends it after `use`. */
export async function withDriver<T>({ root, chromium, say }: DriverOptions, use: (judge: Judge) => Promise<T>): Promise<T> {
  say('Starting the browser…');
  const bundled = bundleScript(root, PAGE_ENTRY, 'scrimShaders');
  let driver: Driver | null = await startDriver(bundled, chromium);

  async function judge(jobs: readonly DriverPage.ShaderJob[], limitS: number | null = null) {
    driver ??= await startDriver(bundled, chromium);
    const { browser, page } = driver;
    const judged = page.evaluate((all) => (globalThis as unknown as { scrimShaders: typeof DriverPage }).scrimShaders.judge(all), jobs);
    if (limitS === null) return judged;
    const verdicts = await within(limitS, judged);
    if (verdicts === null) {
      driver = null;
      // The page has been closed, so its answer is ignored.
      judged.catch(() => undefined);
      await browser.close();
    }
    return verdicts;
  }

  try {
    return await use(judge as Judge);
  } finally {
    await driver?.browser.close();
  }
}

interface Driver {
  readonly browser: Browser;
  readonly page: Page;
}

async function startDriver(bundled: Promise<string>, chromium: Chromium): Promise<Driver> {
  const [script, browser] = await Promise.all([bundled, startBrowser(chromium)]);
  const page = await browser.newPage();
  await page.addScriptTag({ content: script });
  return { browser, page };
}

/** Resolves to null if the answer takes too long. */
function within<T>(limitS: number, answer: Promise<T>): Promise<T | null> {
  const limit = AbortSignal.timeout(limitS * 1000);
  const late = new Promise<null>((resolve) => {
    limit.addEventListener('abort', () => resolve(null));
  });
  return Promise.race([answer, late]);
}

/** Driver messages of one shader, mapped to source lines. */
export function verdictDiagnostics(
  shader: LinkedShader,
  { logs, endlessLine }: DriverPage.ShaderVerdict = { logs: [], endlessLine: null },
  sourceOf?: (file: string) => string | undefined,
): Diagnostic[] {
  const endless = endlessLine === null ? [] : [tooManyIterations(shader, endlessLine)];
  return [...logs.flatMap(({ log, stage }) => driverDiagnostics(shader, log, sourceOf, stage)), ...endless];
}
