import { afterEach, beforeEach } from '@jest/globals';

/** Returns a function that sets globals of a page until the end of the test. Call it where tests are declared. */
export function useGlobals(...names: readonly string[]): (globals: Readonly<Record<string, unknown>>) => void {
  let before: (readonly [string, PropertyDescriptor | undefined])[] = [];
  beforeEach(() => {
    before = names.map((name) => [name, Object.getOwnPropertyDescriptor(globalThis, name)] as const);
  });
  afterEach(() => {
    for (const [name, descriptor] of before) {
      if (descriptor) Object.defineProperty(globalThis, name, descriptor);
      else Reflect.deleteProperty(globalThis, name);
    }
  });
  return (globals) => {
    for (const [name, value] of Object.entries(globals)) Object.defineProperty(globalThis, name, { value, configurable: true });
  };
}
