// What was skipped, and the last line of CI: `N passed, N failed`, from Jest's own counts. Arguments: pairs of a script's exit status and the file
// that its Jest wrote. Plain JavaScript without packages, because it has to speak also when nothing could be installed.
import { readFileSync } from 'node:fs';
import { relative } from 'node:path';
import process from 'node:process';

let passed = 0;
let failed = 0;
const args = process.argv.slice(2);
for (let i = 0; i < args.length; i += 2) {
  const counts = read(args[i + 1]);
  const own = counts === null ? 1 : counts.numFailedTests + counts.numRuntimeErrorTestSuites;
  for (const line of skipped(counts)) console.log(line);
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

/** One line per suite with skipped tests; the reason is in the names. */
function skipped(report) {
  const lines = new Set();
  for (const { name, assertionResults } of report?.testResults ?? []) {
    for (const { status, ancestorTitles, title } of assertionResults) {
      if (status === 'pending') lines.add(`skipped: ${[relative(process.cwd(), name), ...(ancestorTitles ?? []), title].join(' › ')}`);
    }
  }
  return [...lines];
}
