import { MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import type { LayerRef, Program } from '../../../export/program/program.ts';
import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import { LIBRARY } from '../../services/compile-project.ts';
import { type Call, UsageError } from '../command.ts';
import type { Subject } from './render.page.ts';

export interface FrameRange {
  readonly first: number;
  /** Number of the last frame, included. */
  readonly last: number;
}

export interface SizePx {
  readonly widthPx: number;
  readonly heightPx: number;
}

/** Largest side of a render. WebGL 2 guarantees only 2,048, and browsers silently reduce canvases that are larger than they support. */
const MAX_SIDE_PX = 8192;
const MAX_FRAMES = 100_000;

/**
 * Parses `A..B` or `A`.
 *
 * @throws UsageError
 */
export function readRange(text: string | null): FrameRange {
  if (text === null) return { first: 0, last: 0 };
  const [, a, b] = /^(\d{1,9})(?:\.\.(\d{1,9}))?$/.exec(text) ?? [];
  if (a === undefined) throw new UsageError(`--frames ${text} is not a range. Write 0..59, or one number.`);
  const first = Number(a);
  const last = b === undefined ? first : Number(b);
  if (last < first) throw new UsageError(`--frames ${text} ends before it begins.`);
  if (last - first >= MAX_FRAMES) throw new UsageError(`--frames ${text} are more than ${MAX_FRAMES} frames.`);
  return { first, last };
}

/**
 * Parses `WxH`.
 *
 * @throws UsageError
 */
export function readSize(text: string | null): SizePx | null {
  if (text === null) return null;
  const [, width, height] = /^(\d{1,5})[x×](\d{1,5})$/i.exec(text) ?? [];
  const widthPx = Number(width);
  const heightPx = Number(height);
  if (widthPx >= 1 && heightPx >= 1 && widthPx <= MAX_SIDE_PX && heightPx <= MAX_SIDE_PX) return { widthPx, heightPx };
  throw new UsageError(`--size ${text} is not a size. Write 1280x720, each side from 1 to ${MAX_SIDE_PX}.`);
}

/** Layers that the compiler must keep for these options. */
export function tapsFor(call: Call, project: Project): readonly string[] {
  const tap = tapOf(call, project);
  return tap === null ? [] : [tap];
}

/** What a render writes: the screen output, a layer, or the depth of a layer. SCR012 if the layer does not exist. */
export function subjectOf(call: Call, project: Project, program: Program): Result<Subject> {
  const tap = tapOf(call, project);
  if (tap === null) return { output: { kind: 'screen' }, diagnostics: [] };
  if (call.text('depth') === null) {
    const layer = findLayer(tap, project, program);
    return layer.output === null ? { ...layer, output: null } : { output: { kind: 'layer', tap }, diagnostics: [] };
  }
  const layer = findDeepLayer(tap, project, program);
  return layer.output === null ? { ...layer, output: null } : { output: { kind: 'depth', tap }, diagnostics: [] };
}

/** Finds a layer that the compiler has kept. SCR012 if it does not exist. */
function findLayer(tap: string, project: Project, program: Program): Result<LayerRef> {
  const layer = Object.hasOwn(program.taps, tap) ? program.taps[tap] : undefined;
  if (layer) return { output: layer, diagnostics: [] };
  const some = layersOf(project).join(', ');
  return wrong(`Layer ${tap} does not exist, or its inputs are not connected.`, `Layers of this project: ${some}.`);
}

/** Finds a layer with depth. SCR012 if it does not exist, or has none. */
export function findDeepLayer(tap: string, project: Project, program: Program): Result<LayerRef> {
  const found = findLayer(tap, project, program);
  return found.output?.depth === null ? wrong(`Layer ${tap} has no depth.`, 'Name the layer of a scene.') : found;
}

function tapOf(call: Call, project: Project): string | null {
  const depth = call.text('depth');
  if (depth !== null && depth !== '') return depth;
  const layer = call.text('layer');
  if (layer !== null || depth === null) return layer;
  return screenLayer(project);
}

/** The layer that is connected to the Output. */
export function screenLayer({ graphs }: Project): string | null {
  const { nodes = {}, wires = [] } = graphs[MAIN_GRAPH] ?? {};
  const wire = wires.find(({ to }) => LIBRARY.definition(nodes[to.node]?.type ?? '')?.lowering.kind === 'present');
  return wire ? `${wire.from.node}.${wire.from.port}` : null;
}

function layersOf({ graphs }: Project): string[] {
  return Object.entries(graphs[MAIN_GRAPH]?.nodes ?? {}).flatMap(([id, { type }]) =>
    Object.entries(LIBRARY.definition(type)?.outputs ?? {}).flatMap(([port, output]) => (output.type === 'layer' ? [`${id}.${port}`] : [])),
  );
}

function wrong(message: string, fix: string): Result<never> {
  const diagnostic: Diagnostic = { code: 'SCR012', severity: 'error', message, fix };
  return { output: null, diagnostics: [diagnostic] };
}
