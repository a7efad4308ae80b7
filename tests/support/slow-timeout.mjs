import { beforeEach, jest } from '@jest/globals';

// 10 minutes; see `testTimeout` in jest.config.mjs.
const LIMIT_MS = 600_000;
jest.setTimeout(LIMIT_MS);

// Without it, a file whose tests all wait until their timeouts takes the time of the other files.
const endMs = performance.now() + LIMIT_MS;
beforeEach(() => {
  if (performance.now() > endMs) throw new Error('This test does not run, because those before it in the file took more than 10 minutes.');
});
