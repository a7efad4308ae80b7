import { join } from 'node:path';
import process from 'node:process';
import { BrowserWindow, dialog, ipcMain } from 'electron';
import type { HostService } from '../services/host.ts';
import { connectEditor } from './ipc.ts';
import { ORIGINS } from './scheme.ts';

export interface EditorWindow {
  readonly window: BrowserWindow;
  /** Closes the window without asking. */
  closeNow(): void;
}

/**
 * Opens the window. Its close button asks the editor, which may have unsaved changes. If the editor does not respond, the user may
 * close anyway.
 */
export function openEditorWindow(host: HostService): EditorWindow {
  const window = new BrowserWindow({
    width: 1440,
    height: 900,
    minWidth: 800,
    minHeight: 560,
    show: false,
    title: 'Scrim',
    backgroundColor: '#1b1d21',
    // On other systems, the program file contains the icon.
    ...(process.platform === 'linux' ? { icon: join(__dirname, 'scrim.png') } : {}),
    webPreferences: {
      preload: join(__dirname, 'preload.cjs'),
      contextIsolation: true,
      sandbox: true,
      nodeIntegration: false,
      webviewTag: false,
      spellcheck: false,
    },
  });
  let listening = false;
  let closing = false;
  const disconnect = connectEditor(ipcMain, window.webContents, host, () => {
    listening = true;
  });
  const closeNow = () => {
    closing = true;
    if (!window.isDestroyed()) window.close();
  };

  window.once('ready-to-show', () => window.show());
  window.on('close', (event) => {
    if (closing || !listening) return;
    event.preventDefault();
    host.emit({ kind: 'close-requested' });
  });
  window.on('closed', disconnect);
  window.webContents.on('did-navigate', () => {
    listening = false;
  });
  window.webContents.on('render-process-gone', (_event, { reason }) => {
    listening = false;
    dialog.showErrorBox('Scrim', `The editor stopped (${reason}). Your unsaved work is kept; open the project to recover it.`);
    closeNow();
  });
  let asking = false;
  window.on('unresponsive', () => {
    if (asking) return;
    asking = true;
    const answered = new AbortController();
    window.once('responsive', () => answered.abort());
    void askWhetherToWait(window, answered.signal, closeNow).finally(() => {
      asking = false;
    });
  });
  void window.loadURL(`${ORIGINS.editor}/`);
  return { window, closeNow };
}

/**
 * Asks whether to wait for the editor. If `reacts` aborts because the editor responds again, the dialog closes as if “Wait” was
 * chosen.
 */
async function askWhetherToWait(window: BrowserWindow, reacts: AbortSignal, closeNow: () => void): Promise<void> {
  const { response } = await dialog.showMessageBox(window, {
    signal: reacts,
    type: 'warning',
    message: 'Scrim is not responding.',
    detail: 'Your unsaved work is kept; open the project again to recover it.',
    buttons: ['Wait', 'Close'],
    defaultId: 0,
    cancelId: 0,
  });
  if (response === 1) closeNow();
}
