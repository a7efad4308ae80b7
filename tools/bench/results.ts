import type { Measured } from './bench.ts';

/** A row of `bench/results.csv`. */
export interface Recorded extends Measured {
  readonly date: string;
  readonly version: string;
  readonly commit: string;
}

const COLUMNS = ['date', 'version', 'commit', 'name', 'unit', 'median', 'p95'] as const;

/** Relative change below which a difference is noise. */
const NOTABLE = 0.05;

export function readResults(csv: string): Recorded[] {
  const [, ...lines] = csv.trim().split('\n');
  return lines.map((line) => {
    const [date = '', version = '', commit = '', name = '', unit = 'ms', median = '', p95 = ''] = splitRow(line);
    return { date, version, commit, name, unit: unit as Measured['unit'], median: Number(median), p95: Number(p95) };
  });
}

/** Adds rows to the text of the file. */
export function appendResults(csv: string, rows: readonly Recorded[]): string {
  const start = csv === '' ? `${COLUMNS.join(',')}\n` : csv;
  return start + rows.map((row) => `${COLUMNS.map((column) => quote(String(row[column]))).join(',')}\n`).join('');
}

/** A Markdown table of the results, with the last recorded ones. */
export function printTable(measured: readonly Measured[], recorded: readonly Recorded[]): string {
  const rows = measured.map((m) => {
    const last = recorded.filter((r) => r.name === m.name && r.unit === m.unit).at(-1);
    return [m.name, `${figure(m.median)} ${m.unit}`, `${figure(m.p95)} ${m.unit}`, last ? figure(last.median) : '', change(m, last)];
  });
  const table = [['bench', 'median', 'p95', 'recorded', 'change'], ['---', '---:', '---:', '---:', '---:'], ...rows];
  return table.map((cells) => `| ${cells.join(' | ')} |\n`).join('');
}

function change({ median }: Measured, last: Recorded | undefined): string {
  if (!last || last.median === 0) return '';
  const ratio = median / last.median - 1;
  return Math.abs(ratio) < NOTABLE ? '' : `${ratio > 0 ? '+' : '−'}${Math.abs(ratio * 100).toFixed(0)} %`;
}

/** Rounds to four digits. More are noise on two busy cores. */
function figure(value: number): string {
  return String(Number(value.toPrecision(4)));
}

function quote(cell: string): string {
  return /[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell;
}

function splitRow(line: string): string[] {
  const cells = [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)];
  return cells.map(([, quoted, plain]) => (quoted === undefined ? (plain ?? '') : quoted.replaceAll('""', '"')));
}
