import { posix } from 'node:path';
import { pathMatcher } from './match.ts';
import { readGlobalUses } from './raw-globals.ts';
import { type ImportUse, readImports } from './read-imports.ts';
import { lineOf, parseFile, type SourceFile } from './syntax.ts';
import { LAYERS, type Layer, MAX_LINES, RAW_GLOBALS } from './table.ts';

/** `path:line: message`, ready to print. */
export type Problem = string;

export interface InputFile {
  /** Relative to the repository, `/` between parts. */
  readonly path: string;
  readonly text: string;
}

/** The empty path stands for what lies outside the repository. */
const OUTSIDE = '';

const layerMatchers = LAYERS.map((layer) => ({ layer, matches: pathMatcher(layer.files) }));
const globalRules = Object.values(RAW_GLOBALS).map(({ names, files }) => ({ names: new Set<string>(names), matches: pathMatcher(files) }));

/** Everything wrong with the files by the table: directions, packages, raw globals, lengths. */
export function checkFiles(files: readonly InputFile[]): Problem[] {
  return files.flatMap((file) => checkFile(file));
}

function checkFile({ path, text }: InputFile): Problem[] {
  const layer = layerOf(path);
  if (!layer) return [`${path}:1: belongs to no layer. Put it into a folder that tools/layers/table.ts knows.`];
  if (layer.noCode) return [`${path}:1: ${layer.name} holds no code: write a shader, or a folder below nodes/.`];
  const file = parseFile(path, text);
  const imports = readImports(file).map((use) => [use, importProblem(path, layer, use)] as const);
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
  // Vite's suffixes: `./x.worker.ts?worker`.
  const specifier = use.specifier.replace(/\?.*$/, '');
  if (!specifier.startsWith('.')) return packageProblem(layer, specifier, use.typeOnly);
  const target = resolve(from, specifier);
  if (target === OUTSIDE) return `${specifier} lies outside the repository.`;
  if (posix.extname(target) === '') return `${specifier} needs its file extension.`;
  return fileProblem(from, layer, target, use.typeOnly);
}

function packageProblem(layer: Layer, specifier: string, typeOnly: boolean): string | null {
  if (layer.name === 'tests') return null;
  const name = packageName(specifier);
  if (layer.packages?.includes(name) || (typeOnly && layer.types?.includes(name))) return null;
  if (layer.types?.includes(name)) return `${layer.name} may import only types of ${name}: use \`import type\`.`;
  return `${layer.name} may not import ${name === 'node:*' ? specifier : name}.`;
}

/** `three/addons/x.js` → `three`; `node:fs` → `node:*`. */
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
