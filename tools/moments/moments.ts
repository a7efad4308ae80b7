import type { Page } from 'playwright-core';

/** A moment of the first hour with the editor. */
export interface Moment {
  readonly name: string;
  /** The project that is open, relative to the root; null for the start screen. */
  readonly project: string | null;
  /** Goes to the moment. `exported` is a folder for an exported page. */
  readonly reach: (page: Page, exported: string) => Promise<void>;
  /** Whether the moment is the exported page on a phone. */
  readonly onPhone?: true;
}

/** Name of the folder for exported pages. */
export const EXPORTED = 'exported';

const EXPORT_MS = 300_000;
const EFFECT = 'examples/templates/filter';
const FIRST_LIGHT = 'examples/first-light';
const LARGE = 'examples/the-world-in-the-book';

/** Time after which a layer without an image, such as one that waits for a sensor, is no longer waited for. */
const THUMBNAILS_MS = 5000;

/** Waits until the preview plays the newest program. */
export async function isSettled(page: Page): Promise<void> {
  await page.locator('.react-flow__node').first().waitFor();
  await page.waitForFunction(
    () =>
      document.querySelector('.stage')?.getAttribute('aria-busy') === 'false' &&
      !/Compiling/.test(document.querySelector('.status-bar')?.textContent ?? ''),
  );
}

/** Waits until the visible nodes have their thumbnails. */
export async function isPainted(page: Page): Promise<void> {
  const areDrawn = () => [...document.querySelectorAll<HTMLCanvasElement>('.node-thumbnail canvas')].every(({ width }) => width > 0);
  await page.waitForFunction(areDrawn, null, { timeout: THUMBNAILS_MS }).catch(() => {});
}

async function run(page: Page, command: string): Promise<void> {
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Command' }).fill(command);
  await page.keyboard.press('Enter');
}

async function exportPage(page: Page, folder: string): Promise<void> {
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await page.getByRole('textbox', { name: 'Folder', exact: true }).fill(folder);
  await page.keyboard.press('Enter');
  await page.getByText(/^Exported to/).waitFor({ timeout: EXPORT_MS });
}

const stay = async (): Promise<void> => {};

const title = (page: Page, stem: string) => page.locator(`[data-node^="${stem}"] .node-title`).first();

/** The moments in the order in which a designer meets them. */
export const MOMENTS: readonly Moment[] = [
  { name: '01-start', project: null, reach: (page) => page.getByRole('button', { name: 'New project: Empty' }).waitFor() },
  { name: '02-empty', project: 'examples/templates/empty', reach: stay },
  { name: '03-first-effect', project: EFFECT, reach: stay },
  { name: '04-first-light', project: FIRST_LIGHT, reach: stay },
  { name: '05-thumbnails-far', project: LARGE, reach: (page) => run(page, 'Fit graph to view') },
  {
    name: '06-thumbnails-near',
    project: LARGE,
    reach: async (page) => {
      // By the node, because far away it shows no title.
      await page.locator('[data-node^="screen"]').first().click();
      await run(page, 'Show the selection');
    },
  },
  {
    name: '07-shader',
    project: EFFECT,
    reach: async (page) => {
      await title(page, 'ink').click();
      await page.getByRole('button', { name: 'Edit shader', exact: true }).click();
      await page.locator('.monaco-editor .view-line').first().waitFor();
    },
  },
  {
    name: '08-subgraph',
    project: EFFECT,
    reach: async (page) => {
      await title(page, 'ink').click();
      await title(page, 'lines').click({ modifiers: ['Shift'] });
      await page.keyboard.press('Control+g');
      // Beside the title, which a double-click edits.
      await page.locator('[data-node^="subgraph"]').dblclick({ position: { x: 40, y: 45 } });
      await isSettled(page);
      await run(page, 'Fit graph to view');
    },
  },
  { name: '09-timeline', project: FIRST_LIGHT, reach: (page) => run(page, 'Timeline') },
  { name: '10-export', project: FIRST_LIGHT, reach: exportPage },
  { name: '11-phone', project: FIRST_LIGHT, reach: exportPage, onPhone: true },
];
