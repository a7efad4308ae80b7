/// <reference types="webxr" />
import type { Emulator } from '../../export/emulator/emulator.ts';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { enterWith, type Stage, TABLE_ROOM } from './emulator-kit.ts';

/** What a page finds, by the name that the test gives the fact. */
export type Facts = Readonly<Record<string, unknown>>;

export async function withDevice<T>(options: EmulatorOptions, act: (emulator: Emulator) => Promise<T>): Promise<T> {
  const emulator = installEmulator({ clock: 'manual', room: TABLE_ROOM, sizePx: [64, 64], display: false, ...options });
  try {
    return await act(emulator);
  } finally {
    await emulator.uninstall();
  }
}

export function within<T>(options: EmulatorOptions, init: XRSessionInit, act: (stage: Stage) => Promise<T>): Promise<T> {
  return withDevice(options, async (emulator) => {
    const stage = await enterWith(emulator, init);
    try {
      return await act(stage);
    } finally {
      await stage.leave();
    }
  });
}

/** Whether it is the same object when it is asked for again. */
export function isSame(ask: () => unknown): boolean {
  const once = ask();
  return once === ask();
}
