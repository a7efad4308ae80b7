import { type App, BrowserWindow, dialog, Menu, protocol, session } from 'electron';
import type { PlatformMenu } from '../contract/contract.ts';
import { createHost } from '../services/host.ts';
import type { Installation } from '../services/installation.ts';
import { type EditorWindow, openEditorWindow } from './editor-window.ts';
import { guardContents, guardSession } from './guards.ts';
import { menuTemplate, shapeOfMenus } from './menu.ts';
import { ORIGINS, registerScheme, serveScheme } from './scheme.ts';

/** What `scrim open` adds to the command line. */
const OPEN_SWITCH = '--open=';

const PICK_TITLES = {
  new: 'Folder for the New Project',
  open: 'Open Project',
  'save-as': 'Save Project As',
  export: 'Export Page',
  render: 'Folder for the Rendered Frames',
} as const;

/** Runs the editor in a window until that is closed. */
export function startApp(app: App, installation: Installation): void {
  registerScheme(protocol);
  guardContents(app);
  app.on('window-all-closed', () => app.quit());
  let startPath = pathInArguments(process.argv, app.isPackaged);
  // macOS sends a document that was opened as an event, before it is ready.
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
        showMenus,
      },
      installation,
      startPath,
      log: (message) => console.error(message),
    });
    serveScheme(protocol, host.content);
    // What the editor's page offers follows when it is there.
    showMenus([]);
    editor = openEditorWindow(host);
    app.on('quit', () => host.dispose());
  });
}

/** Builds the window's menu where it has become another one; else only says what can be chosen in it, so that an open one stays open. */
function menuShower(app: App, send: (command: string) => void): (menus: readonly PlatformMenu[]) => void {
  let shape: string | null = null;
  return (menus) => {
    const next = shapeOfMenus(menus);
    if (next === shape) {
      const menu = Menu.getApplicationMenu();
      for (const entry of menus.flatMap(({ entries }) => entries)) {
        const item = entry === 'line' ? null : menu?.getMenuItemById(entry.command);
        if (item && entry !== 'line') item.enabled = entry.enabled;
      }
      return;
    }
    shape = next;
    Menu.setApplicationMenu(Menu.buildFromTemplate(menuTemplate(menus, { platform: process.platform, packaged: app.isPackaged, send })));
  };
}

/** `--open=PATH`; a packaged app also takes the plain path that desktops call it with. */
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
