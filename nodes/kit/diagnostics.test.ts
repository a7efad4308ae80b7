import { describe, expect, test } from '@jest/globals';
import { type Diagnostic, formatDiagnostic } from './diagnostics.ts';

const print = (place: Partial<Diagnostic>) => formatDiagnostic({ code: 'SCR022', severity: 'error', message: 'No.', ...place });

describe('a diagnostic in one line', () => {
  test.each<[Partial<Diagnostic>, string]>([
    [{}, 'error SCR022: No.'],
    [{ file: 'a.fs', line: 3, column: 5 }, 'a.fs:3:5: error SCR022: No.'],
    [{ file: 'a.fs', line: 3, nodeId: 'n-a' }, 'a.fs:3 n-a: error SCR022: No.'],
    [{ nodeId: 'n-a', port: 'amount' }, 'n-a.amount: error SCR022: No.'],
    [{ nodeId: 'n-a', port: 'amount', column: 7 }, 'n-a.amount:7: error SCR022: No.'],
    [{ fix: 'Mend it.' }, 'error SCR022: No. Mend it.'],
  ])('says where, as far as it is known: %j', (place, text) => {
    expect(print(place)).toBe(text);
  });
});
