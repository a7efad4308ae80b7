/** Scanned rooms are read with the classes of browsers, of which this one is missing in Node. Import this file before it is needed. */
Object.assign(globalThis, {
  DOMPointReadOnly: class {
    constructor(
      readonly x = 0,
      readonly y = 0,
      readonly z = 0,
      readonly w = 1,
    ) {}
  },
});
