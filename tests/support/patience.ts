/**
 * Timeout of waits in tests. It ends waits that cannot succeed; it does not measure speed, because test machines may be slow and
 * busy. Jest’s own limit (`testTimeout` in jest.config.mjs) is far higher.
 */
export const PATIENCE_MS = 180_000;

/** Interval between checks of state that has no event. */
const LOOK_EVERY_MS = 50;

/**
 * Repeats a check until it passes, and returns its result. After the timeout, its error fails the test. For asynchronous effects of
 * an action: `await eventually(async () => expect(await nodes.count()).toBe(3))`.
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
