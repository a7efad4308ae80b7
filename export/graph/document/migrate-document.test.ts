import { describe, expect, test } from '@jest/globals';
import { type DocumentFormat, migrateDocument, newestVersion } from './migrate-document.ts';

/** A format with a history, to prove the machinery before the real one has any. */
const FORMAT: DocumentFormat = {
  file: 'project.scrim.json',
  format: 'scrim-project',
  steps: [({ name, ...rest }) => ({ ...rest, title: name }), (json) => ({ ...json, title: `${(json.title as string).trim()}!` })],
};

describe('migrateDocument', () => {
  test('lifts through every version', () => {
    expect(newestVersion(FORMAT)).toBe(3);
    expect(migrateDocument({ format: 'scrim-project', version: 1, name: ' Fox ' }, FORMAT)).toEqual({
      ok: true,
      json: { format: 'scrim-project', version: 3, title: 'Fox!' },
    });
    expect(migrateDocument({ format: 'scrim-project', version: 2, title: 'Fox' }, FORMAT)).toMatchObject({
      json: { version: 3, title: 'Fox!' },
    });
  });

  test('the newest version stays as it is', () => {
    const json = { format: 'scrim-project', version: 3, title: ' Fox' };
    expect(migrateDocument(json, FORMAT)).toEqual({ ok: true, json });
  });

  test.each([
    [{ format: 'scrim-project', version: 4 }, 'SCR003'],
    [{ format: 'scrim-layout', version: 1 }, 'SCR002'],
    [{ format: 'scrim-project', version: 1.5 }, 'SCR002'],
    [{ format: 'scrim-project', version: 0 }, 'SCR002'],
    [{ format: 'scrim-project', version: '1' }, 'SCR002'],
    [{ format: 'scrim-project', version: 2, title: 7 }, 'SCR002'],
    [null, 'SCR002'],
    [[], 'SCR002'],
  ])('%j is refused', (json, code) => {
    expect(migrateDocument(json, FORMAT)).toMatchObject({ ok: false, code });
  });
});
