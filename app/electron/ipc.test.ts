import { describe, expect, test } from '@jest/globals';
import type { IpcMain, WebContents } from 'electron';
import type { HostEvent } from '../contract/contract.ts';
import type { HostService } from '../services/host.ts';
import { CALL_CHANNEL, EVENT_CHANNEL, LISTENING_CHANNEL } from './channels.ts';
import { connectEditor } from './ipc.ts';

/** Electron's side of the channel, as far as the shell sees it. */
function connect() {
  const mainFrame = { url: 'scrim://editor/' };
  const sent: unknown[] = [];
  const page = { mainFrame, isDestroyed: () => false, send: (...args: unknown[]) => sent.push(args) } as unknown as WebContents;
  const handlers = new Map<string, (event: object, ...args: unknown[]) => unknown>();
  const ipc = {
    handle: (channel: string, handler: (event: object) => unknown) => handlers.set(channel, handler),
    on: (channel: string, handler: (event: object) => unknown) => handlers.set(channel, handler),
    removeHandler: (channel: string) => handlers.delete(channel),
    removeListener: (channel: string) => handlers.delete(channel),
  } as unknown as IpcMain;
  let emit: (event: HostEvent) => void = () => {};
  const host = {
    dispatch: async (method: string, input: unknown) => ({ output: [method, input] }),
    subscribe: (listener: (event: HostEvent) => void) => {
      emit = listener;
      return () => {};
    },
  } as unknown as HostService;
  let listening = 0;
  const disconnect = connectEditor(ipc, page, host, () => listening++);
  return { page, mainFrame, handlers, sent, disconnect, emit: (event: HostEvent) => emit(event), listening: () => listening };
}

describe('the Electron channel', () => {
  test('carries the editor’s calls and the host’s events', async () => {
    const { page, mainFrame, handlers, sent, emit, listening } = connect();
    const event = { sender: page, senderFrame: mainFrame };
    expect(await handlers.get(CALL_CHANNEL)?.(event, 'app.info', { a: 1 })).toEqual({ output: ['app.info', { a: 1 }] });
    handlers.get(LISTENING_CHANNEL)?.(event);
    expect(listening()).toBe(1);
    emit({ kind: 'close-requested' });
    expect(sent).toEqual([[EVENT_CHANNEL, { kind: 'close-requested' }]]);
  });

  test.each([
    ['a frame within the page', (page: WebContents) => ({ sender: page, senderFrame: { url: 'scrim://editor/' } })],
    ['a frame that is gone', (page: WebContents) => ({ sender: page, senderFrame: null })],
    ['another window', (page: WebContents) => ({ sender: {}, senderFrame: page.mainFrame })],
    ['the page once it shows something else', (page: WebContents) => at(page, 'scrim://preview/')],
    ['an address that only begins alike', (page: WebContents) => at(page, 'scrim://editor.evil/')],
  ])('refuses %s', async (_name, event) => {
    const { page, handlers, listening } = connect();
    const refused = await handlers.get(CALL_CHANNEL)?.(event(page), 'app.info', {});
    expect(refused).toMatchObject({ diagnostic: { code: 'SCR073' } });
    handlers.get(LISTENING_CHANNEL)?.(event(page));
    expect(listening()).toBe(0);
  });

  test('refuses a method that is no text', async () => {
    const { page, mainFrame, handlers } = connect();
    const event = { sender: page, senderFrame: mainFrame };
    expect(await handlers.get(CALL_CHANNEL)?.(event, { toString: () => 'app.info' }, {})).toMatchObject({ diagnostic: { code: 'SCR073' } });
  });

  test('is gone when disconnected', () => {
    const { handlers, disconnect } = connect();
    disconnect();
    expect([...handlers.keys()]).toEqual([]);
  });
});

function at(page: WebContents, url: string) {
  Object.assign(page.mainFrame, { url });
  return { sender: page, senderFrame: page.mainFrame };
}
