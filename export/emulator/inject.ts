import type { Emulator } from './emulator.ts';
import { installEmulator } from './install-emulator.ts';
import type { EmulatorOptions } from './options.ts';

export interface InjectedEmulator {
  install(options?: EmulatorOptions): Emulator;
  /** The device installed last, for later calls from outside the page. */
  current: Emulator | null;
}

declare global {
  /** Present in pages that load the emulator before their own scripts. */
  var scrimEmulator: InjectedEmulator | undefined;
}

// Entry of a script that tests inject before the page's own: bundle it as an IIFE.
const injected: InjectedEmulator = {
  current: null,
  install: (options) => {
    injected.current = installEmulator(options);
    return injected.current;
  },
};
globalThis.scrimEmulator = injected;
// three.js warns if it is loaded twice. The page's copy and this one share nothing, so the marker is removed.
Reflect.deleteProperty(globalThis, '__THREE__');
