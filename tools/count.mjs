// The last line of CI: `N passed, N failed`, from Jest's own counts. Arguments: pairs of a script's exit status and the file
// that its Jest wrote. Plain JavaScript without packages, because it has to speak also when nothing could be installed.
import { readFileSync } from 'node:fs';
import process from 'node:process';

let passed = 0;
let failed = 0;
const args = process.argv.slice(2);
for (let i = 0; i < args.length; i += 2) {
  const counts = read(args[i + 1]);
  const own = counts === null ? 1 : counts.numFailedTests + counts.numRuntimeErrorTestSuites;
  passed += counts?.numPassedTests ?? 0;
  // A script can also fail by its types, its lint or its build.
  failed += own === 0 && args[i] !== '0' ? 1 : own;
}
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed === 0 ? 0 : 1;

function read(path) {
  try {
    return JSON.parse(readFileSync(path, 'utf8'));
  } catch {
    return null;
  }
}
