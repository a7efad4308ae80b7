import { expect, test } from '@jest/globals';
import { scaleAdvice } from './capture-report.ts';
import { type ImportRecord, importRecordFile, readImportRecord } from './import-record.ts';
import { type ScaleSource, scaleWords } from './scale-source.ts';

const RECORD: Omit<ImportRecord, 'format' | 'version' | 'scale'> = {
  form: 'COLMAP (text)',
  up: '-y',
  metersPerUnit: 2,
  pointCount: 0,
  depth: null,
  depthTriangles: 0,
  withoutPhotograph: [],
  withoutCamera: [],
  warnings: [],
  views: [],
};
const SOURCES: readonly ScaleSource[] = [
  { from: 'given' },
  { from: 'distance', photo: 'a.jpg', meters: 2.1 },
  { from: 'camera-height', photo: 'a.jpg', meters: 1.6 },
  { from: 'depth' },
  { from: 'file', file: 'acquisition.json' },
  { from: 'assumed' },
  { from: 'guessed', meters: 2 },
];

test.each(SOURCES)('a record keeps the scale $from', (scale) => {
  const text = new TextDecoder().decode(importRecordFile({ ...RECORD, scale }));
  expect(readImportRecord(text, 0).scale).toEqual(scale);
});

test('records of version 1 are read: where their scale is from is not known', () => {
  const text = JSON.stringify({ format: 'scrim-import-record', version: 1, ...RECORD });
  const record = readImportRecord(text, 0);
  expect(record).toMatchObject({ version: 2, metersPerUnit: 2, scale: null });
  expect(scaleAdvice(record)).toBeNull();
});

test.each([{ from: 'dreamed' }, { from: 'distance', photo: 'a.jpg' }, { from: 'file' }, 'given', undefined])(
  'refuses the scale %j',
  (scale) => {
    const text = JSON.stringify({ format: 'scrim-import-record', version: 2, ...RECORD, scale });
    expect(() => readImportRecord(text, 0)).toThrow('does not say what an import understood');
  },
);

test('only a scale that may be wrong comes with what to do', () => {
  const advised = SOURCES.filter((scale) => scaleWords(scale).advice !== null).map(({ from }) => from);
  expect(advised).toEqual(['assumed', 'guessed']);
  expect(scaleWords({ from: 'guessed', meters: 2 })).toEqual({
    text: 'guessed: what photographs show is taken to be 2 m away',
    advice: expect.stringContaining('“True size” in the inspector'),
  });
});
