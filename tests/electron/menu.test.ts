import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { ElectronApplication, Page } from 'playwright-core';
import { describeElectron, findElectron, openFirstLight, playedTwiceAfterFault } from '../support/electron.ts';
import { eventually } from '../support/patience.ts';

interface ShownItem {
  readonly label: string;
  readonly accelerator: string | null;
  readonly enabled: boolean;
}

/** An item of the window's menu, by the id of its command; null where there is none. */
function shownItem(app: ElectronApplication, id: string): Promise<ShownItem | null> {
  return app.evaluate(({ Menu }, command) => {
    const item = Menu.getApplicationMenu()?.getMenuItemById(command);
    return item ? { label: item.label, accelerator: item.accelerator ?? null, enabled: item.enabled } : null;
  }, id);
}

/** As a press on it does. */
function choose(app: ElectronApplication, id: string): Promise<void> {
  return app.evaluate(({ Menu, BrowserWindow }, command) => {
    const [window] = BrowserWindow.getAllWindows();
    const item = Menu.getApplicationMenu()?.getMenuItemById(command);
    if (!item?.enabled) throw new Error(`${command} cannot be chosen.`);
    item.click({}, window, window?.webContents);
  }, id);
}

/** The way of the window's own keys, through the page and then the menu, which Playwright's go around. */
function press(app: ElectronApplication, keyCode: string, modifiers: ('control' | 'shift' | 'alt')[]): Promise<void> {
  return app.evaluate(
    ({ BrowserWindow }, [key, held]) => {
      const contents = BrowserWindow.getAllWindows()[0]?.webContents;
      for (const type of ['keyDown', 'keyUp'] as const) contents?.sendInputEvent({ type, keyCode: key, modifiers: held });
    },
    [keyCode, modifiers] as const,
  );
}

const nodes = (page: Page) => page.locator('.react-flow__node-scrim');

describeElectron('the window’s menu in Electron', await findElectron(), (launch) => {
  let base = '';
  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-menu-'));
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  test('mirrors the editor’s menus, its keys and what can be done, and does each thing once', async () => {
    await playedTwiceAfterFault(launch, async (launchWatched) => {
      const project = join(base, 'project');
      const { app, page, errors } = await openFirstLight(launchWatched, project);
      await nodes(page).first().waitFor();

      const labels = await app.evaluate(({ Menu }) => Menu.getApplicationMenu()?.items.map(({ label }) => label));
      expect(labels?.slice(0, 6)).toEqual(['&File', '&Edit', '&Graph', '&Arrange', '&View', '&Preview']);
      await eventually(async () =>
        expect(await shownItem(app, 'edit.duplicate')).toEqual({ label: 'Duplicate', accelerator: 'CmdOrCtrl+D', enabled: false }),
      );

      // What is selected can be duplicated: once by its keys, once by the menu.
      const before = await nodes(page).count();
      await page.locator('[data-node^="warm"] .node-title').click();
      await eventually(async () => expect(await shownItem(app, 'edit.duplicate')).toMatchObject({ enabled: true }));
      await press(app, 'D', ['control']);
      await eventually(async () => expect(await nodes(page).count()).toBe(before + 1));
      await choose(app, 'edit.duplicate');
      await eventually(async () => expect(await nodes(page).count()).toBe(before + 2));
      await choose(app, 'edit.undo');
      await eventually(async () => expect(await nodes(page).count()).toBe(before + 1));
      await choose(app, 'edit.undo');
      await eventually(async () => expect(await nodes(page).count()).toBe(before));
      await eventually(async () => expect(await shownItem(app, 'edit.undo')).toMatchObject({ enabled: false }));

      // Other keys are shown at once. While a question is open, nothing is offered.
      await choose(app, 'help.shortcuts');
      const sheet = page.getByRole('dialog', { name: 'Keyboard and pointer shortcuts' });
      await sheet.waitFor();
      await eventually(async () => expect(await shownItem(app, 'file.new')).toMatchObject({ enabled: false }));
      await sheet.getByRole('button', { name: /^Keys for Duplicate:/ }).click();
      await page.keyboard.press('Control+Alt+d');
      await eventually(async () => expect(await shownItem(app, 'edit.duplicate')).toMatchObject({ accelerator: 'CmdOrCtrl+Alt+D' }));
      await page.keyboard.press('Escape');
      await sheet.waitFor({ state: 'detached' });

      // In a text field, undoing means the text, as it does by keys.
      const title = page.getByRole('textbox', { name: 'Title', exact: true });
      await page.keyboard.press('Escape');
      await page.locator('.react-flow__pane').click({ position: { x: 20, y: 20 } });
      const said = await title.inputValue();
      await title.focus();
      await page.keyboard.press('End');
      await page.keyboard.type('!');
      await eventually(async () => expect(await shownItem(app, 'edit.undo')).toMatchObject({ enabled: true }));
      await choose(app, 'edit.undo');
      await eventually(async () => expect(await title.inputValue()).toBe(said));
      expect(errors).toEqual([]);
    });
  });
});
