import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';

// Jest runs ES modules as they are (three's CommonJS entry cannot be loaded on Node 20), so every script that starts it sets
// NODE_OPTIONS=--experimental-vm-modules; see tools/test.
process.env.SCRIM_PROJECTS ??= join(tmpdir(), `scrim-projects-${process.pid}`);

/** Packages that compute much. */
const COMPUTING = 'three|three-mesh-bvh|fast-png|iobuffer|fflate|@gltf-transform|property-graph|cannon-es|pixelmatch|playwright-core';

const base = {
  testEnvironment: '<rootDir>/tests/support/environment.mjs',
  transform: {
    '\\.(ts|tsx|fs|vs|glsl)$': '<rootDir>/tests/support/transform.mjs',
    [`/node_modules/(?:${COMPUTING})/.*\\.m?js$`]: '<rootDir>/tests/support/transform.mjs',
  },
  transformIgnorePatterns: [`/node_modules/(?!(?:${COMPUTING})/)`],
  extensionsToTreatAsEsm: ['.ts', '.tsx', '.fs', '.vs', '.glsl'],
  modulePathIgnorePatterns: ['<rootDir>/dist', '<rootDir>/tests/output'],
};

/** Each project is one row of the test pyramid; `npm run test:one NAME` runs one. */
function project(displayName, testMatch, more = {}) {
  return { ...base, displayName, testMatch: testMatch.map((glob) => `<rootDir>/${glob}`), ...more };
}

export default {
  // Above what a test waits for (tests/support/patience.ts): it ends what hangs, and is no measure of speed. Jest heeds no timeout
  // of a project's own.
  testTimeout: 420_000,
  reporters: ['default', '<rootDir>/tests/support/long-files.mjs'],
  testSequencer: '<rootDir>/tests/support/longest-first.mjs',
  projects: [
    project('unit', [
      '{app,export,nodes,renderer,tools,shader-library}/**/*.test.ts',
      'tests/unit/**/*.test.ts',
      'tests/compile/**/*.test.ts',
    ]),
    project('browser', ['tests/browser/**/*.test.ts']),
    project('xr', ['tests/xr/**/*.test.ts']),
    project('electron', ['tests/electron/**/*.test.ts']),
    project('slow', ['tests/{slow,hostile}/**/*.test.ts'], { setupFilesAfterEnv: ['<rootDir>/tests/support/slow-timeout.mjs'] }),
  ],
};
