import process from 'node:process';
import type { Browser } from 'playwright-core';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { HostError } from '../contract/host-error.ts';
import type { Chromium } from './chromium.ts';
import { endWithProcess } from './end-with-process.ts';

export const NO_BROWSER: Diagnostic = {
  code: 'SCR071',
  severity: 'error',
  message: 'No browser was found to render with.',
  fix: 'Install Chromium or Chrome, or set SCRIM_CHROMIUM to the path of a browser.',
};

/** Number of attempts. Chromium sometimes exits while it starts, for an unknown reason. */
const STARTS = 2;

/**
 * Starts a headless browser.
 *
 * @param more Additional switches.
 * @throws SCR071 if it does not start
 */
export async function startBrowser(found: Chromium, more: readonly string[] = []): Promise<Browser> {
  // Imported here, so that other commands start faster.
  const { chromium } = await import('playwright-core');
  for (let start = 1; ; start++) {
    try {
      const browser = await chromium.launch({
        executablePath: found.executablePath,
        args: [...found.args, ...more],
        env: { ...process.env, ...found.env } as Record<string, string>,
      });
      await endWithProcess(browser);
      return browser;
    } catch (error) {
      const told = error instanceof Error ? error.message : String(error);
      if (start < STARTS && /has been closed/.test(told)) continue;
      const [reason = ''] = told.replace(/^browserType\.launch: /, '').split('\n');
      const ended = /<process did exit: ([^>]*)>/.exec(told)?.[1];
      const message = `The browser ${found.executablePath} does not start: ${reason}${ended === undefined ? '' : ` (${ended})`}`;
      throw new HostError({ ...NO_BROWSER, message });
    }
  }
}
