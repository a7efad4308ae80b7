import { jest } from '@jest/globals';

// 15 minutes; see `testTimeout` in jest.config.mjs.
jest.setTimeout(900_000);
