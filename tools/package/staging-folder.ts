import { existsSync } from 'node:fs';
import { cp, mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import { isBuiltin } from 'node:module';
import { dirname, join, relative, sep } from 'node:path';
import { readImports } from '../layers/read-imports.ts';
import { parseFile } from '../layers/syntax.ts';
import type { Target } from './target.ts';

/** Folder outside the app’s archive, because esbuild cannot read archives. */
export const OUTSIDE = 'sources';

const SOURCE_FOLDERS = ['export', 'nodes', 'shader-library'];
/** Files of packages that are not needed at run time. */
const NEEDLESS = /\.(?:map|d\.ts|d\.mts|d\.cts|md)$/;

/**
 * Fills the staging folder: the app’s code, which is archived, and in `sources/` the files that pages are bundled from. Requires a
 * complete build.
 */
export async function fillStagingFolder(
  root: string,
  folder: string,
  { platform, arch }: Pick<Target, 'platform' | 'arch'>,
): Promise<void> {
  const { version, description } = JSON.parse(await readFile(join(root, 'package.json'), 'utf8')) as Record<string, string>;
  await put(join(folder, 'package.json'), JSON.stringify({ name: 'scrim', productName: 'Scrim', version, description, main: 'start.cjs' }));
  await cp(join(root, 'tools', 'package', 'start.cjs'), join(folder, 'start.cjs'));
  for (const built of ['electron', 'editor', 'preview']) await copyFolder(join(root, 'dist', built), join(folder, 'dist', built));
  const code = await importedBy(join(root, 'dist', 'electron'), ['main.cjs', 'preload.cjs']);
  // The program of esbuild is that of this system; that of the target is outside the archive.
  const isProgram = (path: string) => path.startsWith('bin/');
  for (const name of await withDependencies(root, code)) await copyPackage(root, name, join(folder, 'node_modules'), isProgram);

  const outside = join(folder, OUTSIDE);
  await put(join(outside, 'package.json'), JSON.stringify({ type: 'module', sideEffects: false }));
  const sources = await copySources(root, outside);
  const bundledLater = await importedBy(
    root,
    sources.filter((path) => BUNDLED_LATER.test(path)),
  );
  bundledLater.delete('esbuild');
  for (const name of await withDependencies(root, bundledLater)) await copyPackage(root, name, join(outside, 'node_modules'));
  await copyEsbuildProgram(root, join(outside, 'node_modules'), `@esbuild/${platform}-${arch}`);
  await cp(join(root, 'node_modules/@iwer/sem/captures'), join(outside, 'node_modules/@iwer/sem/captures'), { recursive: true });
  await copyFolder(join(root, 'examples'), join(outside, 'examples'), () => false);
}

async function copySources(root: string, outside: string): Promise<readonly string[]> {
  const sources: string[] = [];
  for (const folder of SOURCE_FOLDERS) {
    const isNeedless = (path: string) => /(?:^|\/)example\//.test(path) || /\.test\.tsx?$|tsconfig\.json$|README\.md$/.test(path);
    for (const path of await copyFolder(join(root, folder), join(outside, folder), isNeedless)) sources.push(`${folder}/${path}`);
  }
  return sources;
}

/** Sources that the app bundles at run time: pages and workers. Neither contains the emulator. */
const BUNDLED_LATER = /^(?:export\/(?!emulator\/)|nodes\/(?:generated\/workers\/|(?!generated\/))).*\.ts$/;

/** The npm packages that the files import. */
async function importedBy(folder: string, paths: readonly string[]): Promise<Set<string>> {
  const names = new Set<string>();
  for (const path of paths) {
    for (const { specifier, typeOnly } of readImports(parseFile(path, await readFile(join(folder, path), 'utf8')))) {
      if (specifier === null || typeOnly || /^(?:\.|node:|electron$)/.test(specifier) || isBuiltin(specifier)) continue;
      names.add(/^(?:@[^/]+\/)?[^/]+/.exec(specifier)?.[0] ?? specifier);
    }
  }
  return names;
}

async function withDependencies(root: string, names: Iterable<string>): Promise<readonly string[]> {
  const wanted = new Set<string>();
  const add = async (name: string) => {
    const manifest = await readFile(join(root, 'node_modules', name, 'package.json'), 'utf8').catch(() => null);
    if (manifest === null || wanted.has(name)) return;
    wanted.add(name);
    const { dependencies = {} } = JSON.parse(manifest) as { dependencies?: Record<string, string> };
    for (const dependency of Object.keys(dependencies)) await add(dependency);
  };
  for (const name of names) await add(name);
  return [...wanted].sort();
}

async function copyPackage(root: string, name: string, target: string, isNeedless: (path: string) => boolean = () => false): Promise<void> {
  await copyFolder(join(root, 'node_modules', name), join(target, name), (path) => NEEDLESS.test(path) || isNeedless(path));
}

/** Copies the esbuild program for the target system. npm installs only that of the current system, so others must be installed first. */
async function copyEsbuildProgram(root: string, target: string, name: string): Promise<void> {
  const from = join(root, 'node_modules', name);
  if (!existsSync(from)) {
    const { version } = JSON.parse(await readFile(join(root, 'node_modules/esbuild/package.json'), 'utf8')) as { version: string };
    throw new Error(`esbuild's program for that system is not installed: npm install --no-save --force ${name}@${version}`);
  }
  await cp(from, join(target, name), { recursive: true });
}

/** Copies the files of a folder, except hidden ones and those that `isNeedless` accepts. Returns their paths. */
async function copyFolder(
  from: string,
  to: string,
  isNeedless: (path: string) => boolean = (path) => path.endsWith('.map'),
): Promise<readonly string[]> {
  const entries = await readdir(from, { recursive: true, withFileTypes: true }).catch(() => []);
  const paths = entries
    .filter((entry) => entry.isFile())
    .map((entry) => relative(from, join(entry.parentPath, entry.name)).split(sep).join('/'))
    .filter((path) => !/(?:^|\/)\./.test(path) && !isNeedless(path))
    .sort();
  if (paths.length === 0) throw new Error(`${from} is missing or empty.`);
  for (const path of paths) {
    await mkdir(dirname(join(to, path)), { recursive: true });
    await cp(join(from, path), join(to, path));
  }
  return paths;
}

async function put(path: string, text: string): Promise<void> {
  await mkdir(dirname(path), { recursive: true });
  await writeFile(path, `${text}\n`);
}
