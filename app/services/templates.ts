import { readdir } from 'node:fs/promises';
import { basename, join, resolve } from 'node:path';
import { loadProject } from '../../export/graph/load.ts';
import type { Project } from '../../export/graph/project.ts';
import { saveProject } from '../../export/graph/save.ts';
import { copyAssets } from './copy-example.ts';
import { fillEmptyFolder } from './empty-folder.ts';
import { refusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { changesBetween, readProjectFiles } from './project-files.ts';
import { writeAll } from './transaction.ts';

/** A template: a folder in `examples/templates`. */
export interface Template {
  /** Name of the folder. */
  readonly name: string;
  readonly title: string;
  readonly description: string;
}

/** The default template. */
export const DEFAULT_TEMPLATE = 'empty';

/** The templates of Scrim; the default is first. */
export async function findTemplates(templatesDir: string): Promise<Template[]> {
  const entries = await readdir(templatesDir, { withFileTypes: true }).catch(() => []);
  const names = entries.filter((entry) => entry.isDirectory()).map((entry) => entry.name);
  const rank = (name: string) => `${name === DEFAULT_TEMPLATE ? 0 : 1}${name}`;
  names.sort((a, b) => (rank(a) < rank(b) ? -1 : 1));
  return Promise.all(
    names.map(async (name) => {
      const { title, page } = await readTemplate(templatesDir, name);
      return { name, title, description: page.description };
    }),
  );
}

export interface NewProjectJob {
  readonly templatesDir: string;
  readonly template: string;
  /** A new or empty folder. */
  readonly path: string;
  /** Default: made from the name of the folder. */
  readonly title?: string | undefined;
  readonly files: FileLayer;
}

/**
 * Creates a project from a template. Returns its real path.
 *
 * @throws SCR060, SCR061, SCR062, SCR073
 */
export async function createProject({ templatesDir, template, path, title = titleFor(path), files }: NewProjectJob): Promise<string> {
  const known = await findTemplates(templatesDir);
  if (!known.some(({ name }) => name === template)) {
    throw refusal('SCR073', `Unknown template ${JSON.stringify(template)}.`, `Choose one of ${known.map(({ name }) => name).join(', ')}.`);
  }
  const { page, ...rest } = await readTemplate(templatesDir, template);
  // The description is for those who choose a template, not for the visitors of a page.
  const project: Project = { ...rest, page: { ...page, description: '' }, title };
  return fillEmptyFolder(path, files, async (root) => {
    await copyAssets(join(templatesDir, template), root, files);
    await writeAll(root, changesBetween(null, saveProject(project)), files);
  });
}

async function readTemplate(templatesDir: string, name: string): Promise<Project> {
  const { output } = loadProject(await readProjectFiles(join(templatesDir, name)));
  if (output === null) throw new Error(`The template ${name} is no project.`);
  return output;
}

/** Makes a title from a folder name: `my-first_effect` → `My first effect`. */
function titleFor(path: string): string {
  const words = basename(resolve(path))
    .split(/[-_\s]+/)
    .filter((word) => word !== '')
    .join(' ');
  return words === '' ? 'Untitled' : words.charAt(0).toUpperCase() + words.slice(1);
}
