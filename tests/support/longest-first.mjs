import { readFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import Sequencer from '@jest/test-sequencer';

/** Assumed duration of a file that is not recorded, because it is short. */
const SHORT_S = 1;
const recordedS = JSON.parse(readFileSync(join(import.meta.dirname, 'durations.json'), 'utf8'));

/**
 * Starts the longest test files first, so that no worker is left with one at the end. Jest does so from its second run on a machine; the
 * first run would go by the size of files. `npm run record-durations` updates the record.
 */
export default class LongestFirst extends Sequencer {
  time(test) {
    const path = relative(test.context.config.rootDir, test.path).split(sep).join('/');
    return super.time(test) ?? 1000 * (recordedS[path] ?? SHORT_S);
  }
}
