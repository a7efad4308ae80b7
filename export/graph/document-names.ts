import type { Project } from './project.ts';
import { getOwn } from './record.ts';

/** Names that documents allow. The patterns exclude `__proto__` and whole numbers, which JavaScript objects sort before all other keys. */
const WORDS = /^[a-z][a-z0-9]*(?:-[a-z0-9]+)*$/;
const STEM_AND_SUFFIX = /^[a-z][a-z0-9]*(?:-[a-z0-9]+)+$/;
const IDENTIFIER = /^[A-Za-z_][A-Za-z0-9_]*$/;
/**
 * Pattern of the name of a shader file without its ending. Names of published ISF files include `3d Rotate.fs` and `CMYK Halftone (v2).fs`.
 */
const FILE_STEM = String.raw`[\p{L}\p{N}_](?:[\p{L}\p{N} ._+()-]*[\p{L}\p{N}_)+-])?`;
const NODE_TYPE = new RegExp(`^[a-z][a-z0-9-]*/${FILE_STEM}$`, 'u');
const SHADER_FILE = new RegExp(`^${FILE_STEM}\\.(?:fs|vs|glsl)$`, 'u');
/** Pattern of the file of a chunk; `#include` can refer to all such names. */
const CHUNK_FILE = /^chunks\/(?:[A-Za-z0-9_-]+\/)*[A-Za-z0-9_-]+\.glsl$/;

const MAX_LENGTH = 128;

/** Whether the text is a node id: a readable stem and a suffix, as in `sepia-k7q2`. */
export function isNodeId(text: string): boolean {
  return text.length <= MAX_LENGTH && STEM_AND_SUFFIX.test(text);
}

/** Whether the text is an id of an asset, node frame or note, or the name of a graph. */
export function isEntryId(text: string): boolean {
  return text.length <= MAX_LENGTH && WORDS.test(text);
}

/** Whether the text is the name of a port or param. They are GLSL identifiers, as ISF inputs are. */
export function isPortName(text: string): boolean {
  return text.length <= MAX_LENGTH && IDENTIFIER.test(text) && text !== '__proto__';
}

export function isNodeType(text: string): boolean {
  return text.length <= MAX_LENGTH && NODE_TYPE.test(text);
}

/**
 * Whether the text is the name of a file in `shaders/`: `edge.fs`, its vertex shader `edge.vs`, the technique `ink.glsl` or the chunk
 * `chunks/ink/dots.glsl`.
 *
 * @example
 * isShaderFile('3d Rotate.fs'); // true
 * isShaderFile('../edge.fs'); // false
 */
export function isShaderFile(text: string): boolean {
  return text.length <= MAX_LENGTH && (SHADER_FILE.test(text) || isChunkFile(text));
}

/**
 * Whether the text is the name of a chunk, which techniques include and which adds no node type.
 *
 * @example
 * isChunkFile('chunks/ink/dots.glsl'); // true
 * isChunkFile('ink.glsl'); // false
 */
export function isChunkFile(text: string): boolean {
  return text.length <= MAX_LENGTH && CHUNK_FILE.test(text);
}

const MAX_STEM = 60;

/**
 * Creates a file name for a shader from its title.
 *
 * @example
 * makeShaderFile('Ripples (deep)'); // 'ripples-deep.fs'
 */
export function makeShaderFile(title: string): string {
  const words = title
    .normalize('NFKC')
    .toLowerCase()
    .split(/[^\p{L}\p{N}]+/u)
    .filter((word) => word !== '');
  return `${words.join('-').slice(0, MAX_STEM).replace(/-$/, '') || 'shader'}.fs`;
}

/**
 * Files in `shaders/` that may define a type, most likely first: `edge.fs` for `filter/edge`, `ink.glsl` for `technique/ink`, and `wipe.fs`
 * or the transition `wipe.glsl` for `operator/wipe`.
 *
 * @example
 * shaderFilesOf('operator/wipe'); // ['wipe.fs', 'wipe.glsl']
 */
export function shaderFilesOf(type: string): readonly string[] {
  const [kind = '', name = ''] = type.split('/');
  if (kind === 'technique') return [`${name}.glsl`];
  return kind === 'operator' ? [`${name}.fs`, `${name}.glsl`] : [`${name}.fs`];
}

const GRAPH_PREFIX = 'graph/';

/**
 * @returns The name of the subgraph whose type this is, or null for a type of the library.
 *
 * @example
 * subgraphName('graph/glow'); // 'glow'
 * subgraphName('filter/sepia'); // null
 */
export function subgraphName(type: string): string | null {
  return type.startsWith(GRAPH_PREFIX) ? type.slice(GRAPH_PREFIX.length) : null;
}

/**
 * @returns The node type of a subgraph: `graph/NAME`.
 *
 * @example
 * subgraphType('glow'); // 'graph/glow'
 */
export function subgraphType(name: string): string {
  return `${GRAPH_PREFIX}${name}`;
}

/** Letters and digits that are not easily confused. */
const SUFFIX_LETTERS = 'abcdefghjkmnpqrstuvwxyz23456789';
const SUFFIX_LENGTH = 4;

/**
 * Creates an id for a node. No node of any graph has it, and two people who add nodes at the same time hardly get the same (1 in 900,000),
 * so their files merge.
 *
 * @param random Returns numbers in [0, 1).
 *
 * @example
 * makeNodeId(project, 'filter/gaussian-blur', random); // 'gaussian-blur-x7k2'
 */
export function makeNodeId(project: Pick<Project, 'graphs'>, type: string, random: () => number): string {
  return makeId(stemOf(type), random, (id) => Object.values(project.graphs).some((graph) => getOwn(graph.nodes, id) !== undefined));
}

/**
 * Creates an id for an asset from its file name.
 *
 * @param random Returns numbers in [0, 1).
 *
 * @example
 * makeAssetId(project, 'assets/statue.glb', random); // 'statue-x7k2'
 */
export function makeAssetId(project: Pick<Project, 'assets'>, path: string, random: () => number): string {
  return makeId(stemOf(path.replace(/\.[^./]*$/, '')), random, (id) => getOwn(project.assets, id) !== undefined);
}

export type LayoutKind = 'frame' | 'note' | 'reroute';

/**
 * Creates an id for a node frame, a note or a reroute of the graph.
 *
 * @param random Returns numbers in [0, 1).
 *
 * @example
 * makeLayoutId(project, 'main', 'frame', random); // 'frame-x7k2'
 */
export function makeLayoutId(project: Pick<Project, 'layout'>, graph: string, kind: LayoutKind, random: () => number): string {
  const layout = getOwn(project.layout, graph);
  const entries = layout?.[`${kind}s`] ?? {};
  return makeId(kind, random, (id) => getOwn<unknown>(entries, id) !== undefined);
}

function makeId(stem: string, random: () => number, taken: (id: string) => boolean): string {
  const count = SUFFIX_LETTERS.length ** SUFFIX_LENGTH;
  const start = Math.floor(random() * count);
  for (let i = 0; i < count; i++) {
    const id = `${stem}-${suffix((start + i) % count)}`;
    if (!taken(id)) return id;
  }
  throw new Error(`No id is left for ${stem}.`);
}

function suffix(index: number): string {
  let text = '';
  for (let rest = index, i = 0; i < SUFFIX_LENGTH; i++) {
    text += SUFFIX_LETTERS[rest % SUFFIX_LETTERS.length];
    rest = Math.floor(rest / SUFFIX_LETTERS.length);
  }
  return text;
}

/** The last part of a path as an id: `filter/CMYK Halftone` → `cmyk-halftone`. */
function stemOf(path: string): string {
  const words = path
    .slice(path.lastIndexOf('/') + 1)
    .normalize('NFKD')
    .toLowerCase()
    .split(/[^a-z0-9]+/)
    .filter((word) => word !== '');
  const stem = words.join('-').slice(0, 40).replace(/-$/, '');
  return /^[a-z]/.test(stem) ? stem : stem === '' ? 'node' : `node-${stem}`;
}
