import process from 'node:process';
import type { Browser } from 'playwright-core';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { Chromium } from '../services/chromium.ts';

export const NO_BROWSER: Diagnostic = {
  code: 'SCR071',
  severity: 'error',
  message: 'No browser was found to render with.',
  fix: 'Install Chromium or Chrome, or name its program in SCRIM_CHROMIUM.',
};

export async function startBrowser(found: Chromium): Promise<Browser> {
  // Loaded here, because other commands start faster without it.
  const { chromium } = await import('playwright-core');
  return chromium.launch({
    executablePath: found.executablePath,
    args: [...found.args],
    env: { ...process.env, ...found.env } as Record<string, string>,
  });
}
