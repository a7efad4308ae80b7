import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import type { Found } from './find-nodes.ts';
import { HEADER } from './header.ts';
import { WORKERS_FOLDER, workerFile } from './workers.ts';

/** Text of `definitions.gen.ts`: all node types and shader texts as data, so that an import parses no shader. */
export function printDefinitions(found: Found, isfDefinitions: readonly NodeDefinition[]): string {
  const imports = found.nodes.map(({ type }) => `import { definition as ${identifier(type)} } from '../${type}/definition.ts';\n`);
  const entries = [
    ...found.nodes.map(({ type }) => `  ${identifier(type)},\n`),
    ...isfDefinitions.map((definition) => `  ${JSON.stringify(definition)},\n`),
  ];
  const shaders = [...found.library, ...found.nodeShaders].map(({ name, text }) => `  ${JSON.stringify(name)}: ${JSON.stringify(text)},\n`);
  return [
    HEADER,
    "import type { NodeDefinition } from '../kit/definition.ts';\n",
    ...imports,
    '\nexport const DEFINITIONS: readonly NodeDefinition[] = [\n',
    ...entries,
    '];\n\n/** ISF files and techniques by the name that `lowering.shader` gives; chunks as `chunks/NAME.glsl`, fonts as `fonts/NAME`. */\n',
    'export const SHADERS: Readonly<Record<string, string>> = {\n',
    ...shaders,
    '};\n',
  ].join('');
}

/** Text of `recipes.gen.ts`: the recipes of the palette, as the texts of their projects. */
export function printRecipes({ recipes }: Found): string {
  return [
    HEADER,
    '\n/** Name of a recipe → its project. */\n',
    'export const RECIPES: Readonly<Record<string, { readonly project: string; readonly layout: string | null }>> = {\n',
    ...recipes.map(({ name, project, layout }) => `  ${JSON.stringify(name)}: ${JSON.stringify({ project, layout })},\n`),
    '};\n',
  ].join('');
}

/** Text of `runtimes.gen.ts`: the runtimes of all node types, for pages that play any project. */
export function printRuntimes(found: Found): string {
  const played = playedTypes(found);
  return [
    HEADER,
    "import type { PlayedModule } from '../kit/cpu-filter.ts';\n",
    ...played.map(({ type, file }) => `import * as ${identifier(type)} from '${relative(file)}';\n`),
    '\n/** Node type → its behavior; also of what params are bound to. Nodes that are only a shader, or only a sink, have none. */\n',
    'export const RUNTIMES: Readonly<Record<string, PlayedModule>> = {\n',
    ...played.map(({ type }) => `  ${JSON.stringify(type)}: ${identifier(type)},\n`),
    '};\n',
  ].join('');
}

/** Text of `runtime-files.gen.ts`: paths of the runtimes, so that an exported page includes only the used ones. */
export function printRuntimeFiles(found: Found): string {
  return [
    HEADER,
    '\n/** Node type → path of its runtime, relative to the repository. */\n',
    'export const RUNTIME_FILES: Readonly<Record<string, string>> = {\n',
    ...playedTypes(found).map(({ type, file }) => `  ${JSON.stringify(type)}: ${JSON.stringify(`nodes/${file}`)},\n`),
    '};\n',
  ].join('');
}

interface Played {
  readonly type: string;
  /** Path of the runtime, relative to `nodes/`. */
  readonly file: string;
}

function playedTypes({ nodes, parts }: Found): Played[] {
  const runtime = (type: string): Played => ({ type, file: `${type}/runtime.ts` });
  return [
    ...nodes.flatMap(({ type, hasRuntime, hasWorker }) => {
      if (hasWorker) return [{ type, file: `generated/${WORKERS_FOLDER}/${workerFile(type)}` }];
      return hasRuntime ? [runtime(type)] : [];
    }),
    ...parts.map(runtime),
  ];
}

/** Converts a path relative to `nodes/` to an import path from `nodes/generated/`. */
function relative(file: string): string {
  return file.startsWith('generated/') ? file.replace('generated/', './') : `../${file}`;
}

/** Makes an identifier from a node type: `layer/depth-occlusion` → `layerDepthOcclusion`. */
function identifier(type: string): string {
  return type.replace(/[^a-z0-9]+(.)/gi, (_, letter: string) => letter.toUpperCase());
}
