import { readIsf } from '../../../export/glsl/isf/read-isf.ts';
import { boundValue } from '../../../export/graph/library/param-value.ts';
import type { Project } from '../../../export/graph/project.ts';
import type { AssetKind, NodeLibrary } from '../../../nodes/kit/definition.ts';
import { type DocumentState, type OpenInfo, titleOf } from '../editor/document.ts';

/** A use of an asset by a node. */
export interface AssetUse {
  readonly graph: string;
  readonly node: string;
}

interface FoundUse extends AssetUse {
  readonly depthMeshes: boolean;
}

/** An asset of the project, or an image that its shaders load. */
export interface AssetRow {
  /** Id in the asset table; null for an image that only shaders load. */
  readonly id: string | null;
  readonly path: string;
  readonly kind: AssetKind;
  /** Size of its files on disk; null if a file is missing. */
  readonly bytes: number | null;
  readonly uses: readonly AssetUse[];
  /** Names of the shaders that load it. */
  readonly shaders: readonly string[];
  /** Whether a node draws the depth meshes of a capture. */
  readonly depthMeshes: boolean;
}

export interface ListedAssets {
  readonly rows: readonly AssetRow[];
  /** Files in `assets/` that belong to no row. Exports leave them out. */
  readonly others: OpenInfo['assetFiles'];
}

type Files = OpenInfo['assetFiles'];

/** Lists the assets of a project. A capture, which is a folder, is one row. */
export function listAssets({ project, library, open }: Pick<DocumentState, 'project' | 'library' | 'open'>): ListedAssets {
  const files = open?.assetFiles ?? [];
  const uses = usesOf(project, library);
  const loaded = loadedByShaders(project.sources);
  const own = Object.entries(project.assets).map(([id, { path, kind }]) => ({
    id,
    path,
    kind,
    bytes: sizeOf(files, path, kind),
    uses: uses.get(id) ?? [],
    shaders: loaded.get(path) ?? [],
    depthMeshes: (uses.get(id) ?? []).some((use) => use.depthMeshes),
  }));
  const paths = new Set(own.map(({ path }) => path));
  const images = [...loaded].flatMap(([path, shaders]): AssetRow[] =>
    paths.has(path) ? [] : [{ id: null, path, kind: 'image', bytes: sizeOf(files, path, 'image'), uses: [], shaders, depthMeshes: false }],
  );
  const rows = [...own, ...images].sort((a, b) => (a.path < b.path ? -1 : 1));
  const covered = (path: string) => path === project.page.poster || rows.some((row) => row.path === path || isPartOf(path, row));
  return { rows, others: files.filter(({ path }) => !covered(path)) };
}

export function isUnused({ id, uses, shaders }: AssetRow): boolean {
  return id !== null && uses.length + shaders.length === 0;
}

/** The names of the nodes that use an asset, each once. */
export function namesOfUses(
  { project, library }: Pick<DocumentState, 'project' | 'library'>,
  uses: readonly AssetUse[],
): readonly string[] {
  return [...new Set(uses.map(({ graph, node }) => titleOf({ project, library, graph }, node)))];
}

/** The nodes that use each asset, by asset id. */
function usesOf(project: Project, library: NodeLibrary): Map<string, FoundUse[]> {
  const uses = new Map<string, FoundUse[]>();
  for (const [graph, { nodes }] of Object.entries(project.graphs)) {
    for (const [node, { type, params }] of Object.entries(nodes)) {
      const declared = library.definition(type)?.params ?? {};
      for (const [name, binding] of Object.entries(params)) {
        const param = declared[name];
        const value = param?.type === 'asset' ? boundValue(binding) : undefined;
        if (typeof value !== 'string' || value === '') continue;
        const when = param?.type === 'asset' ? param.depthMeshes : undefined;
        const chosen = when && (params[when.param] ?? { value: declared[when.param]?.default ?? '' });
        const depthMeshes = chosen !== undefined && boundValue(chosen) === when?.is;
        uses.set(value, [...(uses.get(value) ?? []), { graph, node, depthMeshes }]);
      }
    }
  }
  return uses;
}

/** The images that shaders load by their headers: project path → shaders. */
function loadedByShaders(sources: Project['sources']): Map<string, string[]> {
  const loaded = new Map<string, string[]>();
  for (const [name, text] of Object.entries(sources)) {
    // Reading a header takes long compared with this test.
    if (!name.endsWith('.fs') || !text.includes('"IMPORTED"')) continue;
    for (const { paths } of readIsf(text, name).output?.imported ?? []) {
      for (const path of paths) {
        const whole = path.replace(/^(\.\.\/)+/, '');
        loaded.set(whole, [...(loaded.get(whole) ?? []), name]);
      }
    }
  }
  return loaded;
}

function sizeOf(files: Files, path: string, kind: AssetKind): number | null {
  if (!files.some((file) => file.path === path)) return null;
  const isPart = (other: string) => (kind === 'capture' ? other.startsWith(folderOf(path)) : other === path);
  return files.reduce((sum, file) => sum + (isPart(file.path) ? file.bytes : 0), 0);
}

/** Files that a .gltf model may refer to. */
const PARTS = /\.(bin|png|jpe?g|webp|ktx2)$/i;

/** Whether a file may belong to an asset of several files: a capture, or a .gltf model, which is not read for this. */
function isPartOf(path: string, { path: whole, kind }: AssetRow): boolean {
  if (kind === 'capture') return path.startsWith(folderOf(whole));
  return kind === 'model' && whole.endsWith('.gltf') && PARTS.test(path) && path.startsWith(folderOf(whole));
}

/** The folder of a file, with a slash at its end. */
function folderOf(path: string): string {
  return path.slice(0, path.lastIndexOf('/') + 1);
}
