import { cp, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { exportProject } from '../../app/services/export-project.ts';
import { installationAt } from '../../app/services/installation.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import { bundleEmulator } from './bundle-emulator.ts';

/** How to open an exported page in an emulated device with a manual clock. */
export interface EmulatedPageOptions {
  readonly root: string;
  /** Folder of the exported page. */
  readonly folder: string;
  readonly sizePx: { readonly width: number; readonly height: number };
  /** Options of the emulated device. */
  readonly device: object;
  /** Runs in the page before its own scripts, when the device is there. */
  readonly script: () => void;
}

const ORIGIN = 'https://example.invalid/';
const TYPES: Readonly<Record<string, string>> = { html: 'text/html', js: 'text/javascript', json: 'application/json' };

/** The global of the emulated device, as far as this file uses it. Functions that run in the page find it in `globalThis`. */
interface WithEmulator {
  readonly scrimEmulator: { install(options: object): void; readonly current: { frameRequested(): Promise<void> } };
}

/**
 * Exports a copy of an example. Returns the folder of the page, inside `base`.
 *
 * @param edit Changes the text of the project.
 */
export async function exportExample(root: string, example: string, base: string, edit = (text: string): string => text): Promise<string> {
  const folder = join(base, 'project');
  const out = join(base, 'page');
  await cp(join(root, 'examples', example), folder, { recursive: true });
  const path = join(folder, 'project.scrim.json');
  await writeFile(path, edit(await readFile(path, 'utf8')));
  const installation = installationAt(root, '0.0.0');
  const { report, diagnostics } = await exportProject({ root: folder, projectFiles: await readProjectFiles(folder), out, installation });
  if (report === null) throw new Error(`${example} cannot be exported: ${JSON.stringify(diagnostics)}`);
  return out;
}

/** Opens an exported page, enters AR and waits until the page requests its first frame. */
export async function openEmulatedPage(browser: Browser, { root, folder, sizePx, device, script }: EmulatedPageOptions): Promise<Page> {
  const page = await browser.newPage({ viewport: sizePx });
  await page.addInitScript({ content: await bundleEmulator(root) });
  await page.addInitScript((given: object) => (globalThis as unknown as WithEmulator).scrimEmulator.install(given), {
    clock: 'manual',
    ...device,
  });
  await page.addInitScript(script);
  await page.route(`${ORIGIN}**`, async (route) => {
    const path = new URL(route.request().url()).pathname.slice(1) || 'index.html';
    const contentType = TYPES[path.split('.').at(-1) ?? ''] ?? 'application/octet-stream';
    await route.fulfill({ body: await readFile(join(folder, path)), contentType });
  });
  await page.goto(ORIGIN);
  await page.getByRole('button', { name: 'Enter AR' }).click();
  await page.evaluate(() => (globalThis as unknown as WithEmulator).scrimEmulator.current.frameRequested());
  return page;
}
