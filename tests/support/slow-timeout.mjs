import { jest } from '@jest/globals';

// A quarter of an hour: see `testTimeout` in jest.config.mjs.
jest.setTimeout(900_000);
