import { type App, BrowserWindow, dialog, Menu, protocol, session, shell } from 'electron';
import type { PlatformMenu } from '../contract/contract.ts';
import { createHost } from '../services/host.ts';
import type { Installation } from '../services/installation.ts';
import { type EditorWindow, openEditorWindow } from './editor-window.ts';
import { guardContents, guardSession } from './guards.ts';
import { menuTemplate, shapeOfMenus } from './menu.ts';
import { ORIGINS, registerScheme, serveScheme } from './scheme.ts';

/** Command line switch that `scrim open` adds. */
const OPEN_SWITCH = '--open=';

const PICK_TITLES = {
  new: 'Folder for the New Project',
  open: 'Open Project',
  'save-as': 'Save Project As',
  export: 'Export Page',
  render: 'Folder for the Rendered Frames',
  photographs: 'Folder of Photographs',
} as const;

/** Runs the editor in a window until it is closed. */
export function startApp(app: App, installation: Installation): void {
  registerScheme(protocol);
  guardContents(app);
  app.on('window-all-closed', () => app.quit());
  let startPath = pathInArguments(process.argv, app.isPackaged);
  // macOS sends a project that the user opened as an event, possibly before the app is ready.
  app.on('open-file', (event, path) => {
    event.preventDefault();
    startPath = path;
  });
  void app.whenReady().then(() => {
    guardSession(session.defaultSession);
    let editor: EditorWindow | null = null;
    const showMenus = menuShower(app, (command) => host.emit({ kind: 'menu', command }));
    const host = createHost({
      shell: {
        kind: 'electron',
        origins: ORIGINS,
        pickFolder: (purpose) => pickFolder(PICK_TITLES[purpose]),
        closeWindow: () => editor?.closeNow(),
        revealFile: (path) => shell.showItemInFolder(path),
        openInBrowser: (url) => shell.openExternal(url),
        showMenus,
      },
      installation,
      startPath,
      log: (message) => console.error(message),
    });
    serveScheme(protocol, host.content);
    // The editor’s page sends its menus later.
    showMenus([]);
    editor = openEditorWindow(host);
    app.on('quit', () => void host.dispose());
  });
}

/**
 * Rebuilds the native menu only if its structure changes. Changes of enabled states are applied to the existing menu, so that an open
 * menu stays open.
 */
function menuShower(app: App, send: (command: string) => void): (menus: readonly PlatformMenu[]) => void {
  let shape: string | null = null;
  return (menus) => {
    const next = shapeOfMenus(menus);
    if (next === shape) {
      const menu = Menu.getApplicationMenu();
      for (const entry of menus.flatMap(({ entries }) => entries)) {
        const item = entry === 'line' ? null : menu?.getMenuItemById(entry.command);
        if (!item || entry === 'line') continue;
        item.enabled = entry.enabled;
        if (entry.checked !== null) item.checked = entry.checked;
      }
      return;
    }
    shape = next;
    Menu.setApplicationMenu(Menu.buildFromTemplate(menuTemplate(menus, { platform: process.platform, packaged: app.isPackaged, send })));
  };
}

/** The path to open: that of `--open=PATH`, or in a packaged app also a plain argument, as desktops pass it. */
function pathInArguments(argv: readonly string[], packaged: boolean): string | null {
  const named = argv.find((argument) => argument.startsWith(OPEN_SWITCH));
  if (named !== undefined) return named.slice(OPEN_SWITCH.length);
  return (packaged ? argv.slice(1).find((argument) => !argument.startsWith('-')) : undefined) ?? null;
}

async function pickFolder(title: string): Promise<string | null> {
  const options = { title, properties: ['openDirectory', 'createDirectory'] as ('openDirectory' | 'createDirectory')[] };
  const window = BrowserWindow.getFocusedWindow() ?? BrowserWindow.getAllWindows()[0];
  const { filePaths } = window ? await dialog.showOpenDialog(window, options) : await dialog.showOpenDialog(options);
  return filePaths[0] ?? null;
}
