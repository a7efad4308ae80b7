import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { listFiles, readIfThere } from '../lib/files.ts';

/** A folder `nodes/CATEGORY/NAME`. */
export interface NodeFolder {
  /** `CATEGORY/NAME`, which is also the node's type. */
  readonly type: string;
  readonly hasRuntime: boolean;
  /** Whether the folder has a `worker.ts`: the worker of a CPU filter, or one that the runtime of the node uses. */
  readonly hasWorker: boolean;
}

/** A shader text with its name in `lowering.shader`. */
export interface ShaderFile {
  /** Name such as `filters/sepia.fs` for the library, or `layer/depth-occlusion/occlusion.fs` for a node’s folder. */
  readonly name: string;
  readonly text: string;
}

export interface Found {
  readonly nodes: readonly NodeFolder[];
  /** Runtimes of `nodes/binding/`, which play bindings of params, and of `nodes/part/` (`OutputPort.part`). They are not node types. */
  readonly parts: readonly string[];
  /** ISF files and techniques, each of which is a node type, and the chunks and images (as base64) that techniques include. */
  readonly library: readonly ShaderFile[];
  /** Shaders that a node's definition names. */
  readonly nodeShaders: readonly ShaderFile[];
  readonly recipes: readonly RecipeFolder[];
}

/** A folder `shader-library/recipes/NAME`, which is a project. */
export interface RecipeFolder {
  readonly name: string;
  /** Text of `project.scrim.json`. */
  readonly project: string;
  /** Text of `project.layout.json`; null if there is none. */
  readonly layout: string | null;
}

const LIBRARY_FOLDERS = ['filters', 'operators', 'generators', 'techniques', 'chunks', 'pictures'] as const;

/** Functions that ISF files contain copies of (`npm run sync-chunks`). They are not included anywhere. */
const MASTERS = 'chunks/isf';

/**
 * Finds all node folders, which are those with a definition, and shaders. Sorted, so that the result does not depend on the system.
 */
export async function findNodes(root: string): Promise<Found> {
  const paths = await listFiles(join(root, 'nodes'), (path) => path === 'generated' || path.endsWith('/example'));
  const inFolders = paths.filter((path) => path.split('/').length === 3);
  const present = new Set(inFolders);
  const nodes = inFolders
    .filter((path) => path.endsWith('/definition.ts'))
    .map((path) => path.slice(0, -'/definition.ts'.length))
    .map((type) => ({ type, hasRuntime: present.has(`${type}/runtime.ts`), hasWorker: present.has(`${type}/worker.ts`) }));
  const parts = inFolders.flatMap((path) => /^((?:binding|part)\/[^/]+)\/runtime\.ts$/.exec(path)?.[1] ?? []);
  return {
    nodes,
    parts,
    library: await readLibrary(root),
    nodeShaders: await readShaders(join(root, 'nodes'), inFolders.filter(isShader)),
    recipes: await readRecipes(join(root, 'shader-library', 'recipes')),
  };
}

async function readRecipes(folder: string): Promise<RecipeFolder[]> {
  const files = await listFiles(folder);
  const names = files.flatMap((path) => /^([^/]+)\/project\.scrim\.json$/.exec(path)?.[1] ?? []);
  return Promise.all(
    names.map(async (name) => ({
      name,
      project: await readFile(join(folder, name, 'project.scrim.json'), 'utf8'),
      layout: await readIfThere(join(folder, name, 'project.layout.json')),
    })),
  );
}

async function readLibrary(root: string): Promise<ShaderFile[]> {
  const base = join(root, 'shader-library');
  const perFolder = await Promise.all(
    LIBRARY_FOLDERS.map(async (kind) =>
      (await listFiles(join(base, kind), (path) => `${kind}/${path}` === MASTERS)).map((name) => `${kind}/${name}`),
    ),
  );
  return readShaders(
    base,
    perFolder.flat().filter((path) => isShader(path) || isPicture(path)),
  );
}

function readShaders(base: string, names: readonly string[]): Promise<ShaderFile[]> {
  return Promise.all(names.map(async (name) => ({ name, text: await readFile(join(base, name), isPicture(name) ? 'base64' : 'utf8') })));
}

/**
 * Whether a file is a shader: `.fs` is an ISF file, `.vs` the vertex shader of the ISF file of the same name, `.glsl` a technique or chunk.
 */
function isShader(path: string): boolean {
  return path.endsWith('.fs') || path.endsWith('.vs') || path.endsWith('.glsl');
}

function isPicture(path: string): boolean {
  return path.endsWith('.png');
}
