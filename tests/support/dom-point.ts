/** Adds a class of browsers that Node does not have, with which scanned rooms are read. Call it before one is made. */
export function addDomPoint(): void {
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
}
