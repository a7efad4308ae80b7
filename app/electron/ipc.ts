import type { IpcMain, IpcMainEvent, IpcMainInvokeEvent, WebContents } from 'electron';
import type { Answer } from '../contract/host-error.ts';
import type { HostService } from '../services/host.ts';
import { CALL_CHANNEL, EVENT_CHANNEL, LISTENING_CHANNEL } from './channels.ts';
import { ORIGINS } from './scheme.ts';

/**
 * Connects the editor’s page to the host. Accepts calls only from the main frame of the window while it shows the editor’s origin.
 * Returns a function that disconnects.
 */
export function connectEditor(ipc: IpcMain, page: WebContents, host: HostService, onListening: () => void): () => void {
  // Each load of the page is a new client, so that unsaved changes before a reload are offered for recovery, as after a crash.
  let loads = 0;
  const client = () => `window-${loads}`;
  const call = async (event: IpcMainInvokeEvent, method: unknown, input: unknown): Promise<Answer<unknown>> => {
    if (!isEditor(event, page) || typeof method !== 'string') {
      return { diagnostic: { code: 'SCR073', severity: 'error', message: 'Only the editor’s own page may call this.' } };
    }
    return host.dispatch(method, input, client());
  };
  let leave = () => {};
  const listening = (event: IpcMainEvent) => {
    if (!isEditor(event, page)) return;
    leave();
    leave = host.attend(client());
    onListening();
  };
  const loaded = () => {
    leave();
    leave = () => {};
    loads++;
  };
  ipc.handle(CALL_CHANNEL, call);
  ipc.on(LISTENING_CHANNEL, listening);
  page.on('did-navigate', loaded);
  const stop = host.subscribe((event) => {
    if (!page.isDestroyed()) page.send(EVENT_CHANNEL, event);
  });
  return () => {
    stop();
    leave();
    ipc.removeHandler(CALL_CHANNEL);
    ipc.removeListener(LISTENING_CHANNEL, listening);
  };
}

function isEditor({ sender, senderFrame }: IpcMainEvent | IpcMainInvokeEvent, page: WebContents): boolean {
  return sender === page && senderFrame !== null && senderFrame === page.mainFrame && senderFrame.url.startsWith(`${ORIGINS.editor}/`);
}
