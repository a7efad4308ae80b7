/**
 * How long a test waits for what it waits for: a page to say something, a picture to come. It ends what never comes, and is no
 * measure of speed: the machines that test may be busy and slow. Jest's own limit (`testTimeout` in jest.config.mjs) lies well above.
 */
export const PATIENCE_MS = 180_000;

/** How long between two looks at what makes no event of its own. */
const LOOK_EVERY_MS = 50;

/**
 * Looks until a check passes, and gives what it gave; what it says when patience ends is the test's failure. For what follows an
 * action in its own time: `await eventually(async () => expect(await nodes.count()).toBe(3))`.
 */
export async function eventually<T>(check: () => Promise<T> | T): Promise<T> {
  const endMs = Date.now() + PATIENCE_MS;
  for (;;) {
    try {
      return await check();
    } catch (error) {
      if (Date.now() > endMs) throw error;
    }
    await new Promise((done) => setTimeout(done, LOOK_EVERY_MS));
  }
}
