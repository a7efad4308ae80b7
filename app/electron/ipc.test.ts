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
  let navigated = () => {};
  const page = {
    mainFrame,
    isDestroyed: () => false,
    send: (...args: unknown[]) => sent.push(args),
    on: (_event: 'did-navigate', listener: () => void) => {
      navigated = listener;
    },
  } as unknown as WebContents;
  const handlers = new Map<string, (event: object, ...args: unknown[]) => unknown>();
  const ipc = {
    handle: (channel: string, handler: (event: object) => unknown) => handlers.set(channel, handler),
    on: (channel: string, handler: (event: object) => unknown) => handlers.set(channel, handler),
    removeHandler: (channel: string) => handlers.delete(channel),
    removeListener: (channel: string) => handlers.delete(channel),
  } as unknown as IpcMain;
  let emit: (event: HostEvent) => void = () => {};
  const callers: string[] = [];
  const there = new Set<string>();
  const host = {
    dispatch: async (method: string, input: unknown, client: string) => {
      callers.push(client);
      return { output: [method, input] };
    },
    attend: (client: string) => {
      there.add(client);
      return () => there.delete(client);
    },
    subscribe: (listener: (event: HostEvent) => void) => {
      emit = listener;
      return () => {};
    },
  } as unknown as HostService;
  let listening = 0;
  const disconnect = connectEditor(ipc, page, host, () => listening++);
  return {
    page,
    mainFrame,
    handlers,
    sent,
    disconnect,
    emit: (event: HostEvent) => emit(event),
    listening: () => listening,
    callers,
    there,
    navigate: () => navigated(),
  };
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

  test('takes a page that was reloaded for another one', async () => {
    const { page, mainFrame, handlers, callers, there, navigate } = connect();
    const event = { sender: page, senderFrame: mainFrame };
    navigate();
    handlers.get(LISTENING_CHANNEL)?.(event);
    await handlers.get(CALL_CHANNEL)?.(event, 'app.info', {});
    const [before] = callers;
    expect([...there]).toEqual([before]);
    navigate();
    expect([...there]).toEqual([]);
    handlers.get(LISTENING_CHANNEL)?.(event);
    await handlers.get(CALL_CHANNEL)?.(event, 'app.info', {});
    expect(callers[1]).not.toBe(before);
    expect([...there]).toEqual([callers[1]]);
  });

  test('is gone when disconnected', () => {
    const { page, mainFrame, handlers, there, disconnect } = connect();
    handlers.get(LISTENING_CHANNEL)?.({ sender: page, senderFrame: mainFrame });
    disconnect();
    expect([...handlers.keys()]).toEqual([]);
    expect([...there]).toEqual([]);
  });
});

function at(page: WebContents, url: string) {
  Object.assign(page.mainFrame, { url });
  return { sender: page, senderFrame: page.mainFrame };
}
