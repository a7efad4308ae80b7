import { AsyncLocalStorage } from 'node:async_hooks';
import { TestEnvironment } from 'jest-environment-node';

/** Storages that the running test file has used. */
const used = new Set();

const { run, enterWith } = AsyncLocalStorage.prototype;
AsyncLocalStorage.prototype.run = function (...call) {
  used.add(this);
  return run.apply(this, call);
};
AsyncLocalStorage.prototype.enterWith = function (...call) {
  used.add(this);
  return enterWith.apply(this, call);
};

/**
 * Node’s environment, which ends the storages of asynchronous contexts that Jest and Playwright create for each test file. Node 20 looks
 * at all that were ever used for each new promise: without this, a worker slows down with each file, by half after 80.
 */
export default class Environment extends TestEnvironment {
  async teardown() {
    await super.teardown();
    for (const storage of used) storage.disable();
    used.clear();
  }
}
