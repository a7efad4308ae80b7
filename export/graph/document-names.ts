import type { Project } from './project.ts';
import { getOwn } from './record.ts';

/**
 * What things in a document may be called. The patterns exclude `__proto__`, and names that are whole numbers, which JavaScript
 * objects would put before all others.
 */
const WORDS = /^[a-z][a-z0-9]*(?:-[a-z0-9]+)*$/;
const STEM_AND_SUFFIX = /^[a-z][a-z0-9]*(?:-[a-z0-9]+)+$/;
const IDENTIFIER = /^[A-Za-z_][A-Za-z0-9_]*$/;
/** ISF files in the wild are called `3d Rotate.fs` or `CMYK Halftone (v2).fs`. */
const FILE_STEM = String.raw`[\p{L}\p{N}_](?:[\p{L}\p{N} ._+()-]*[\p{L}\p{N}_)+-])?`;
const NODE_TYPE = new RegExp(`^[a-z][a-z0-9-]*/${FILE_STEM}$`, 'u');
const SHADER_FILE = new RegExp(`^${FILE_STEM}\\.(?:fs|vs|glsl)$`, 'u');
/** As `#include` can name it. */
const CHUNK_FILE = /^chunks\/(?:[A-Za-z0-9_-]+\/)*[A-Za-z0-9_-]+\.glsl$/;

const MAX_LENGTH = 128;

/** `sepia-k7q2`: a readable stem and a suffix. */
export function isNodeId(text: string): boolean {
  return text.length <= MAX_LENGTH && STEM_AND_SUFFIX.test(text);
}

/** Ids of assets, frames and notes, and names of graphs. */
export function isEntryId(text: string): boolean {
  return text.length <= MAX_LENGTH && WORDS.test(text);
}

/** Ports and params are called as ISF inputs are: GLSL identifiers. */
export function isPortName(text: string): boolean {
  return text.length <= MAX_LENGTH && IDENTIFIER.test(text) && text !== '__proto__';
}

export function isNodeType(text: string): boolean {
  return text.length <= MAX_LENGTH && NODE_TYPE.test(text);
}

/** A file in `shaders/`: `edge.fs`, the vertex shader beside it, the technique `ink.glsl`, or what techniques include, `chunks/ink/dots.glsl`. */
export function isShaderFile(text: string): boolean {
  return text.length <= MAX_LENGTH && (SHADER_FILE.test(text) || isChunkFile(text));
}

/** A piece that techniques include, and no node type by itself; the library's are called the same. */
export function isChunkFile(text: string): boolean {
  return text.length <= MAX_LENGTH && CHUNK_FILE.test(text);
}

const MAX_STEM = 60;

/** A file for a shader that people call `title`: `Ripples (deep)` gives `ripples-deep.fs`. */
export function makeShaderFile(title: string): string {
  const words = title
    .normalize('NFKC')
    .toLowerCase()
    .split(/[^\p{L}\p{N}]+/u)
    .filter((word) => word !== '');
  return `${words.join('-').slice(0, MAX_STEM).replace(/-$/, '') || 'shader'}.fs`;
}

/**
 * The files in `shaders/` that may give a type, likeliest first: `edge.fs` of `filter/edge`, `ink.glsl` of `technique/ink`, and
 * `wipe.fs` or the transition `wipe.glsl` of `operator/wipe`.
 */
export function shaderFilesOf(type: string): readonly string[] {
  const [kind = '', name = ''] = type.split('/');
  if (kind === 'technique') return [`${name}.glsl`];
  return kind === 'operator' ? [`${name}.fs`, `${name}.glsl`] : [`${name}.fs`];
}

const GRAPH_PREFIX = 'graph/';

/** The subgraph that a node type stands for, or null for a type of the library. */
export function subgraphName(type: string): string | null {
  return type.startsWith(GRAPH_PREFIX) ? type.slice(GRAPH_PREFIX.length) : null;
}

export function subgraphType(name: string): string {
  return `${GRAPH_PREFIX}${name}`;
}

/** Without letters that are taken for digits. */
const SUFFIX_LETTERS = 'abcdefghjkmnpqrstuvwxyz23456789';
const SUFFIX_LENGTH = 4;

/**
 * A new id for a node of `type`: `filter/gaussian-blur` gives `gaussian-blur-x7k2`. No node of any graph in the project has it,
 * and two people adding nodes at once are unlikely to (one in 900,000), so that their files merge.
 */
export function makeNodeId(project: Pick<Project, 'graphs'>, type: string, random: () => number): string {
  return makeId(stemOf(type), random, (id) => Object.values(project.graphs).some((graph) => getOwn(graph.nodes, id) !== undefined));
}

/** A new id for an asset, from its file's name. */
export function makeAssetId(project: Pick<Project, 'assets'>, path: string, random: () => number): string {
  return makeId(stemOf(path.replace(/\.[^./]*$/, '')), random, (id) => getOwn(project.assets, id) !== undefined);
}

export type LayoutKind = 'frame' | 'note' | 'reroute';

/** A new id for a frame, a note or a reroute of the graph. */
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

/** `filter/CMYK Halftone` → `cmyk-halftone`. */
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
