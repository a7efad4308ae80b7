import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { expect, test } from '@jest/globals';
import { childrenCpuMs } from './cpu-time.ts';

/** Computes for 0.3 s, says so, and waits to be ended. */
const BUSY = `
while (process.cpuUsage().user < 300_000);
process.stdout.write('done');
setInterval(() => {}, 1000);`;

test('what started programs compute is counted, and nothing where the system does not tell', async () => {
  const before = childrenCpuMs();
  const child = spawn(process.execPath, ['-e', BUSY]);
  try {
    await once(child.stdout, 'data');
    const after = childrenCpuMs();
    if (!existsSync('/proc/self/stat')) {
      expect([before, after]).toEqual([null, null]);
      return;
    }
    const ms = (after ?? 0) - (before ?? 0);
    expect(ms).toBeGreaterThanOrEqual(280);
    // Starting Node takes some, too, and more on a busy machine. A wrong unit would be off by ten or a thousand times.
    expect(ms).toBeLessThan(10_000);
  } finally {
    child.kill();
  }
});
