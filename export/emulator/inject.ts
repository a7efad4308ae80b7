import type { Emulator } from './emulator.ts';
import { installEmulator } from './install-emulator.ts';
import type { EmulatorOptions } from './options.ts';

export interface InjectedEmulator {
  install(options?: EmulatorOptions): Emulator;
  /** The device installed last, for later calls from outside the page. */
  current: Emulator | null;
}

declare global {
  /** There in pages that were given the emulator before their own scripts. */
  var scrimEmulator: InjectedEmulator | undefined;
}

// Entry of a script that tests put into a page before the page's own: bundle it as an IIFE.
const injected: InjectedEmulator = {
  current: null,
  install: (options) => {
    injected.current = installEmulator(options);
    return injected.current;
  },
};
globalThis.scrimEmulator = injected;
// three.js warns when it is loaded twice. The page's copy and ours share nothing, so the page need not hear of ours.
Reflect.deleteProperty(globalThis, '__THREE__');
