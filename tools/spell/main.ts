import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { listFiles } from '../lib/files.ts';
import { runCommand } from '../lib/run-command.ts';
import type { ToolContext } from '../lib/tool.ts';
import { findPhrases } from './phrases.ts';

/**
 * `npm run spell [FILE…]`: checks American spelling by cspell (`cspell.json`, with `docs/words.txt` for the terms of the field), and
 * reports phrases that a reader has to read twice.
 */
export async function main(args: readonly string[], { root }: ToolContext): Promise<number> {
  const problems = await checkPhrases(root, args);
  for (const problem of problems) console.error(problem);
  const files = args.length > 0 ? args : ['.'];
  const spelling = await runCommand('npx', ['cspell', 'lint', '--no-progress', '--no-must-find-files', ...files], { cwd: root });
  return problems.length === 0 && spelling === 0 ? 0 : 1;
}

/** Finds banned phrases in code, comments and docs. Returns a message `path:line: …` for each. */
export async function checkPhrases(root: string, only: readonly string[] = []): Promise<string[]> {
  const paths = only.length > 0 ? only : await listFiles(root, (folder) => folder === 'nodes/generated' || folder === 'tests/output');
  const problems: string[] = [];
  for (const path of paths) {
    if (isProse(path)) problems.push(...findPhrases(path, await readFile(join(root, path), 'utf8')));
  }
  return problems;
}

function isProse(path: string): boolean {
  if (path.startsWith('tools/spell/') || path === 'docs/GLOSSARY.md' || path === 'CHANGELOG.md') return false;
  return /\.(ts|tsx|mjs|md|fs|vs|glsl|css|html)$/.test(path);
}
