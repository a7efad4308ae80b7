import { expect, test } from '@jest/globals';
import { watchDrags } from './drag-watch.ts';

/** A window as far as drags need it. */
function fakeWindow() {
  const listeners = new Map<string, (event: object) => void>();
  const page = {
    addEventListener: (kind: string, listener: (event: object) => void) => void listeners.set(kind, listener),
    removeEventListener: (kind: string) => void listeners.delete(kind),
  };
  return { page: page as unknown as Window, send: (kind: string, event: object = {}) => listeners.get(kind)?.(event), listeners };
}

test('a drag begins with the movement of a pressed pointer, whatever loses the focus then, and ends when it rests or is released', async () => {
  const { page, send, listeners } = fakeWindow();
  const seen: boolean[] = [];
  let rest = () => {};
  const wait = () =>
    new Promise<void>((done) => {
      rest = done;
    });
  const stop = watchDrags(page, wait, (on) => seen.push(on));
  send('pointermove', { clientX: 50, clientY: 0, buttons: 0 });
  send('pointerdown', { clientX: 0, clientY: 0 });
  send('blur', { target: {} });
  send('pointermove', { clientX: 2, clientY: 0, buttons: 1 });
  expect(seen).toEqual([]);
  send('pointermove', { clientX: 9, clientY: 0, buttons: 1 });
  send('pointermove', { clientX: 20, clientY: 0, buttons: 1 });
  expect(seen).toEqual([true]);
  send('pointerup');
  expect(seen).toEqual([true, false]);
  seen.length = 0;
  // The release happened outside of the window.
  send('pointerdown', { clientX: 0, clientY: 0 });
  send('pointermove', { clientX: 9, clientY: 0, buttons: 1 });
  send('blur', { target: page });
  expect(seen).toEqual([true, false]);
  seen.length = 0;
  // It is held still, and moves on.
  send('pointerdown', { clientX: 0, clientY: 0 });
  send('pointermove', { clientX: 9, clientY: 0, buttons: 1 });
  rest();
  await Promise.resolve();
  expect(seen).toEqual([true, false]);
  send('pointermove', { clientX: 10, clientY: 0, buttons: 1 });
  expect(seen).toEqual([true, false, true]);
  stop();
  expect(listeners.size).toBe(0);
});
