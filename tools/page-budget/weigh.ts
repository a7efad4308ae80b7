import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { exportProject } from '../../app/services/export-project.ts';
import { installationAt } from '../../app/services/installation.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import { exampleNames } from '../lib/example-names.ts';

/** Scripts of an exported page, bytes after gzip. */
export interface PageWeight {
  /** What is loaded before the first image. */
  readonly first: number;
  /** All scripts, with the sessions that a visitor may enter. */
  readonly all: number;
}

/** The weights that pages may have: `tools/page-budget/budget.json`. */
export interface PageBudget {
  /** Why the budget was raised, oldest first. */
  readonly reasons: readonly string[];
  /** Name of the example → its weight. */
  readonly pages: Readonly<Record<string, PageWeight>>;
}

/** A page may be heavier than its budget by this share, because the bytes of any change of the runtime are in every page. */
const TOLERANCE = 0.01;

/** Exports all examples to a temporary folder and weighs their scripts. */
export async function weighExamples(root: string): Promise<Readonly<Record<string, PageWeight>>> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-weigh-'));
  const weights: Record<string, PageWeight> = {};
  try {
    for (const name of await exampleNames(root)) weights[name] = await weigh(root, name, join(base, name));
  } finally {
    await rm(base, { recursive: true, force: true });
  }
  return weights;
}

async function weigh(root: string, name: string, out: string): Promise<PageWeight> {
  const folder = join(root, 'examples', name);
  const projectFiles = await readProjectFiles(folder);
  const { report, diagnostics } = await exportProject({ root: folder, projectFiles, out, installation: installationAt(root, '0.0.0') });
  if (report === null) throw new Error(`The example ${name} cannot be exported: ${JSON.stringify(diagnostics)}`);
  const scripts = report.files.filter(({ kind }) => kind === 'script');
  const sum = (files: typeof scripts) => files.reduce((bytes, { gzip }) => bytes + gzip, 0);
  return { first: sum(scripts.filter(({ path }) => path.startsWith('page-'))), all: sum(scripts) };
}

/** Returns a sentence for each page that is heavier than its budget, or has none. */
export function overweight(weights: Readonly<Record<string, PageWeight>>, { pages }: PageBudget): readonly string[] {
  return Object.entries(weights).flatMap(([name, weight]) => {
    const budget = pages[name];
    if (!budget) return [`${name} has no budget.`];
    return (['first', 'all'] as const)
      .filter((key) => weight[key] > budget[key] * (1 + TOLERANCE))
      .map((key) => `${name}: ${WORDS[key]} ${weight[key]} bytes of gzip; its budget is ${budget[key]}.`);
  });
}

const WORDS: Readonly<Record<keyof PageWeight, string>> = { first: 'before the first image', all: 'all scripts' };
