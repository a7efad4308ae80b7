// Jest runs ES modules as they are (three's CommonJS entry cannot be loaded on Node 20), so every script that starts it sets
// NODE_OPTIONS=--experimental-vm-modules; see tools/test.mjs.
const base = {
  testEnvironment: 'node',
  transform: { '\\.(ts|tsx|fs|vs|glsl)$': '<rootDir>/tests/support/transform.mjs' },
  extensionsToTreatAsEsm: ['.ts', '.tsx', '.fs', '.vs', '.glsl'],
  modulePathIgnorePatterns: ['<rootDir>/dist', '<rootDir>/tests/output'],
};

/**
 * Each project is one row of the test pyramid; `npm run test:one NAME` runs one. Timeouts leave room for two busy cores: they
 * end what hangs, and are no measure of speed.
 */
function project(displayName, timeoutS, testMatch) {
  return { ...base, displayName, testTimeout: timeoutS * 1000, testMatch: testMatch.map((glob) => `<rootDir>/${glob}`) };
}

export default {
  projects: [
    project('unit', 20, [
      '{app,export,nodes,renderer,tools,shader-library}/**/*.test.ts',
      'tests/unit/**/*.test.ts',
      'tests/compile/**/*.test.ts',
    ]),
    project('browser', 60, ['tests/browser/**/*.test.ts']),
    project('xr', 120, ['tests/xr/**/*.test.ts']),
    project('electron', 120, ['tests/electron/**/*.test.ts']),
    project('slow', 900, ['tests/slow/**/*.test.ts']),
  ],
};
