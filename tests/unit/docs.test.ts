import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { expect, test } from '@jest/globals';
import { ROOMS } from '../../tools/layers/table.ts';
import { listFiles } from '../../tools/lib/files.ts';

const FILES = await listFiles('.', (path) => path === 'nodes/generated' || path === 'tests/output');
const PAGES = FILES.filter((path) => path.endsWith('.md') && path !== 'CHANGELOG.md');
const DECISIONS = readdirSync('docs/adr').filter((name) => /^\d{4}-/.test(name));

const read = (path: string) => readFileSync(path, 'utf8');

/** As GitHub makes them: lower case, without punctuation, hyphens for spaces. */
function anchors(path: string): string[] {
  const titles = [...read(path).matchAll(/^#+ (.+)$/gm)].map((match) => match[1] ?? '');
  return titles.map((title) =>
    title
      .toLowerCase()
      .replace(/[^\p{L}\p{N} _-]/gu, '')
      .replaceAll(' ', '-'),
  );
}

test('every link between pages leads to a file and a heading', () => {
  const broken = PAGES.flatMap((page) =>
    [...read(page).matchAll(/\]\((?!https?:)([^)#\s]*)(?:#([^)\s]*))?\)/g)].flatMap(([link, path = '', anchor]) => {
      const target = path === '' ? page : join(dirname(page), path);
      if (!existsSync(target)) return [`${page}: ${link}`];
      return anchor !== undefined && target.endsWith('.md') && !anchors(target).includes(anchor) ? [`${page}: ${link}`] : [];
    }),
  );
  expect(broken).toEqual([]);
});

test('the architecture has a row for every folder that the layers know', () => {
  const text = read('docs/ARCHITECTURE.md');
  expect(ROOMS.filter((folder) => !text.includes(`| \`${folder}\` |`))).toEqual([]);
});

test('every file that the architecture names exists', () => {
  const named = [...read('docs/ARCHITECTURE.md').matchAll(/`([\w./-]+\.tsx?)`/g)].map((match) => match[1] ?? '');
  const missing = named.filter((name) => !FILES.some((path) => path === name || path.endsWith(`/${name}`)));
  expect(named.length).toBeGreaterThan(10);
  expect(missing).toEqual([]);
});

test('the table of decisions has the titles of the pages', () => {
  const rows = DECISIONS.map((name) => {
    const [, number, title] = /^# (\d+)\. (.+)$/m.exec(read(`docs/adr/${name}`)) ?? [];
    expect(name.startsWith(String(number).padStart(4, '0'))).toBe(true);
    return `| [${number}](${name}) | ${title} |`;
  });
  const table = read('docs/adr/README.md');
  expect(rows.filter((row) => !table.includes(row))).toEqual([]);
});

test('every decision that code or a page cites has a page', () => {
  const known = new Set(DECISIONS.map((name) => Number.parseInt(name, 10)));
  const cited = FILES.filter((path) => /\.(ts|tsx|mjs|md|glsl|fs)$/.test(path) && path !== 'CHANGELOG.md' && path !== 'docs/adr/README.md');
  const missing = cited.flatMap((path) =>
    [...read(path).matchAll(/\b(?:ADR |adr\/)0*(\d+)/g)]
      .filter((match) => !known.has(Number(match[1])))
      .map(([text]) => `${path}: ${text}`),
  );
  expect(missing).toEqual([]);
});
