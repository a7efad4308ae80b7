import { posix } from 'node:path';
import { findCircles, type Graph } from './circles.ts';
import { readGlobalUses } from './raw-globals.ts';
import { type ImportUse, readImports } from './read-imports.ts';
import { lineOf, parseFile, type SourceFile } from './syntax.ts';
import { FIXED_NAMES, LAYERS, type Layer, MAX_LINES, RAW_GLOBALS, ROOMS, SIBLINGS, UNIQUE_NAMES } from './table.ts';

const TOKENS = /\*\*\/|\*\*|\*|\{|\}|,|[^*{},]+/g;

const TRANSLATIONS: Readonly<Record<string, string>> = {
  '**/': '(?:.*/)?',
  '**': '.*',
  '*': '[^/]*',
  '{': '(?:',
  '}': ')',
  ',': '|',
};

/** A violation as text to print: `path:line: message`. */
export type Problem = string;

export interface InputFile {
  /** Path relative to the repository, with `/`. */
  readonly path: string;
  readonly text: string;
}

/** The empty path stands for all files outside the repository. */
const OUTSIDE = '';

const layerMatchers = LAYERS.map((layer) => ({ layer, matches: pathMatcher(layer.files) }));
const globalRules = Object.values(RAW_GLOBALS).map(({ names, files }) => ({ names: new Set<string>(names), matches: pathMatcher(files) }));

/** Checks files against the table: import directions, packages, raw globals, lengths, import cycles and file names. */
export function checkFiles(files: readonly InputFile[]): Problem[] {
  const imported = new Map<string, ReadonlySet<string>>();
  const problems = files.flatMap((file) => checkFile(file, imported));
  return [...problems, ...circleProblems(imported), ...nameProblems(files.map(({ path }) => path))];
}

/** Checks one file alone, and adds the files that it imports to `imported`. */
function checkFile({ path, text }: InputFile, imported: Map<string, ReadonlySet<string>>): Problem[] {
  const layer = layerOf(path);
  if (!layer) return [`${path}:1: belongs to no layer. Put it into a folder that tools/layers/table.ts knows.`];
  if (layer.noCode) return [`${path}:1: ${layer.name} holds no code: write a shader, or a folder below nodes/.`];
  const file = parseFile(path, text);
  const uses = readImports(file);
  imported.set(
    path,
    new Set(uses.flatMap(({ specifier }) => (specifier?.startsWith('.') ? [resolve(path, withoutQuery(specifier))] : []))),
  );
  const imports = uses.map((use) => [use, importProblem(path, layer, use)] as const);
  const wrongImports = imports.flatMap(([use, problem]) => (problem === null ? [] : [at(file, use.offset, problem)]));
  return [...wrongImports, ...globalProblems(file), ...lengthProblem(file)];
}

function layerOf(path: string): Layer | undefined {
  return layerMatchers.find(({ matches }) => matches(path))?.layer;
}

function importProblem(from: string, layer: Layer, use: ImportUse): string | null {
  if (use.specifier === null) {
    return layer.name === 'tests' || layer.name === 'tools' ? null : 'a computed import cannot be checked: name the file.';
  }
  const specifier = withoutQuery(use.specifier);
  if (!specifier.startsWith('.')) return packageProblem(layer, specifier, use.typeOnly);
  const target = resolve(from, specifier);
  if (target === OUTSIDE) return `${specifier} lies outside the repository.`;
  if (posix.extname(target) === '') return `${specifier} needs its file extension.`;
  return fileProblem(from, layer, target, use.typeOnly);
}

/** Removes the suffix of a Vite import: `./x.worker.ts?worker` → `./x.worker.ts`. */
function withoutQuery(specifier: string): string {
  return specifier.replace(/\?.*$/, '');
}

/** Reports import cycles between files, between rows of the table in ARCHITECTURE, and between sibling folders of the editor. */
function circleProblems(imported: ReadonlyMap<string, ReadonlySet<string>>): Problem[] {
  const files = findCircles(imported).map((circle) => `${circle[0]}:1: files import each other in a circle: ${inOrder(circle)}.`);
  const folders = [roomOf, ...siblingGroups(imported.keys())].flatMap((groupOf) => folderProblems(imported, groupOf));
  return [...files, ...new Set(folders)];
}

function inOrder(circle: readonly string[]): string {
  return [...circle, circle[0]].join(' → ');
}

/** Matches test files. They may import everything, and no file imports them. */
const isTest = pathMatcher(['**/*.test.{ts,tsx}']);

function folderProblems(imported: ReadonlyMap<string, ReadonlySet<string>>, groupOf: (path: string) => string | null): Problem[] {
  const graph = new Map<string, Map<string, string>>();
  for (const [from, targets] of imported) {
    const group = isTest(from) ? null : groupOf(from);
    for (const target of group === null ? [] : targets) {
      const other = groupOf(target);
      if (group === null || other === null || other === group) continue;
      const witnesses = graph.get(group) ?? new Map<string, string>();
      graph.set(group, witnesses.set(other, `${from} imports ${target}`));
    }
  }
  return findCircles(
    new Map([...graph].map(([name, others]): [string, ReadonlySet<string>] => [name, new Set(others.keys())])) as Graph,
  ).map((circle) => {
    const steps = circle.map((name, i) => graph.get(name)?.get(circle[(i + 1) % circle.length] ?? ''));
    return `${circle[0]}: folders import each other in a circle: ${inOrder(circle)} (${steps.join('; ')}).`;
  });
}

/** Reports files of the same name, because a file name alone must identify the file. */
function nameProblems(paths: readonly string[]): Problem[] {
  const first = new Map<string, string>();
  return paths.flatMap((path) => {
    const name = posix.basename(path).replace(/\.\w+$/, '');
    if (isTest(path) || !UNIQUE_NAMES.some((folder) => path.startsWith(`${folder}/`)) || FIXED_NAMES.some((fixed) => fixed === name))
      return [];
    const other = first.get(name);
    first.set(name, other ?? path);
    return other === undefined ? [] : [`${path}:1: has the same name as ${other}. Give it a name that tells which one it is.`];
  });
}

/** The folder of `ROOMS` that contains the path, the most specific one if there are several; null if there is none. */
function roomOf(path: string): string | null {
  return ROOMS.filter((room) => path.startsWith(`${room}/`)).reduce<string | null>(
    (best, room) => (best !== null && best.length >= room.length ? best : room),
    null,
  );
}

/**
 * For each folder, a function that returns the subfolder in which a path lies; null for files directly in the folder, and for paths outside
 * it.
 */
function siblingGroups(paths: Iterable<string>): ((path: string) => string | null)[] {
  const parents = new Set<string>();
  for (const path of paths) {
    if (!SIBLINGS.some((root) => path.startsWith(`${root}/`))) continue;
    for (let folder = posix.dirname(path); SIBLINGS.some((root) => `${folder}/`.startsWith(`${root}/`)); folder = posix.dirname(folder))
      parents.add(folder);
  }
  return [...parents].map((parent) => (path) => {
    if (!path.startsWith(`${parent}/`)) return null;
    const [child = '', ...rest] = path.slice(parent.length + 1).split('/');
    return rest.length === 0 ? null : `${parent}/${child}`;
  });
}

function packageProblem(layer: Layer, specifier: string, typeOnly: boolean): string | null {
  if (layer.name === 'tests') return null;
  const name = packageName(specifier);
  if (layer.packages?.includes(name) || (typeOnly && layer.types?.includes(name))) return null;
  if (layer.types?.includes(name)) return `${layer.name} may import only types of ${name}: use \`import type\`.`;
  return `${layer.name} may not import ${name === 'node:*' ? specifier : name}.`;
}

/** Name of the package in an import: `three/addons/x.js` → `three`; `node:fs` → `node:*`. */
function packageName(specifier: string): string {
  if (specifier.startsWith('node:')) return 'node:*';
  return specifier
    .split('/')
    .slice(0, specifier.startsWith('@') ? 2 : 1)
    .join('/');
}

function fileProblem(from: string, layer: Layer, target: string, typeOnly: boolean): string | null {
  const to = layerOf(target);
  if (!to) return `${target} belongs to no layer.`;
  if (layer.name === 'tests') return null;
  if (layer.own === 'folder' && posix.dirname(from) === posix.dirname(target)) return null;
  if (to === layer && layer.own === undefined) return null;
  if (layer.imports?.includes(to.name) || (typeOnly && layer.types?.includes(to.name))) return null;
  if (layer.types?.includes(to.name)) return `${layer.name} may import only types of ${to.name}: use \`import type\` for ${target}.`;
  return to === layer
    ? `${layer.name} may not import another of its kind: ${target}.`
    : `${layer.name} may not import ${to.name}: ${target}.`;
}

function resolve(from: string, specifier: string): string {
  const target = posix.normalize(posix.join(posix.dirname(from), specifier));
  return target.startsWith('..') ? OUTSIDE : target;
}

function globalProblems(file: SourceFile): Problem[] {
  return globalRules
    .filter((rule) => !rule.matches(file.path))
    .flatMap((rule) => readGlobalUses(file, rule.names))
    .map(({ name, offset }) =>
      at(file, offset, `raw ${name}: take it as an argument (design: injected), or see RAW_GLOBALS in the table.`),
    );
}

function lengthProblem({ path, text }: SourceFile): Problem[] {
  const lines = text.split('\n').length - (text.endsWith('\n') ? 1 : 0);
  return lines > MAX_LINES ? [`${path}:${MAX_LINES + 1}: ${lines} lines; at most ${MAX_LINES}. Split it by idea.`] : [];
}

function at(file: SourceFile, offset: number, message: string): Problem {
  return `${file.path}:${lineOf(file.text, offset)}: ${message}`;
}

/** Turns a path pattern of the table (`*`, `**`, `{a,b}`) into a test of repository paths. */
function pathMatcher(patterns: readonly string[]): (path: string) => boolean {
  const expressions = patterns.map((pattern) => new RegExp(`^${translate(pattern)}$`));
  return (path) => expressions.some((expression) => expression.test(path));
}

function translate(pattern: string): string {
  return pattern.replace(TOKENS, (token) => TRANSLATIONS[token] ?? token.replace(/[.+?^$()|[\]\\]/g, '\\$&'));
}
