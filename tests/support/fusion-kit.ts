import { spawnSync } from 'node:child_process';
import { basename } from 'node:path';
import { createCompiler } from '../../export/compiler/compile.ts';
import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import type { FoldedNode } from '../../export/compiler/fold/folded-node.ts';
import type { SeparateWire } from '../../export/compiler/schedule/fuse/separate-wire.ts';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { PassOperation, Program } from '../../export/program/program.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { LIBRARY } from './library.ts';

/** Colors that change from pixel to pixel and over large areas, of every alpha. Two of them, so that mixing them shows. */
const PATTERNS = {
  'pattern.fs': pattern('0.0'),
  'other.fs': pattern('0.37'),
};

const own = (body: string) => `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/\nvoid main() { ${body} }`;
const at = (x: number, y: number) => `IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(${x}.0, ${y}.0))`;

/** Effects of a project that read pixels exactly: one, one, and three. */
export const EXACT_EFFECTS: Readonly<Record<string, string>> = {
  'filter/shift': own(`gl_FragColor = ${at(3, -2)};`),
  'filter/flip': own('gl_FragColor = IMG_NORM_PIXEL(inputImage, vec2(1.0 - isf_FragNormCoord.x, isf_FragNormCoord.y));'),
  'filter/slope': own(`vec4 c = ${at(0, 0)}; gl_FragColor = vec4(abs(${at(1, 0)}.rgb - ${at(-1, 0)}.rgb), c.a);`),
};

const EXACT_SOURCES = Object.fromEntries(Object.entries(EXACT_EFFECTS).map(([type, text]) => [`${type.slice(7)}.fs`, text]));

function pattern(offset: string): string {
  return `/*{ "ISFVSN": "2" }*/
void main() {
  vec2 cell = floor(gl_FragCoord.xy / 3.0) + ${offset} * 100.0;
  vec3 noise = fract(vec3(0.1031, 0.1130, 0.0973) * (cell.x * 7.0 + cell.y * 13.0 + cell.x * cell.y));
  vec3 slope = vec3(isf_FragNormCoord, fract(isf_FragNormCoord.x + isf_FragNormCoord.y + ${offset}));
  gl_FragColor = vec4(mix(slope, noise, 0.4), clamp(1.4 - noise.x, 0.0, 1.0));
}
`;
}

const { compile } = createCompiler();

/** Two programs that are to draw the same image. */
export interface Twins {
  readonly separate: Program;
  readonly fused: Program;
  /** Wires that the fused one keeps, with the reasons. */
  readonly wires: readonly SeparateWire[];
}

/** Twins of a compilation, with the nodes that folding leaves out. */
export interface CompiledTwins extends Twins {
  readonly folded: readonly FoldedNode[];
}

/** Compiles nodes and wires with and without fusion. */
export function twins(
  nodes: Readonly<Record<string, object>>,
  wires: readonly string[],
  sources: Readonly<Record<string, string>> = {},
  options: CompileOptions = {},
  subgraphs: Readonly<Record<string, object>> = {},
): CompiledTwins {
  const graph = {
    nodes: {
      'pattern-a': { type: 'generator/pattern', version: 1 },
      'other-a': { type: 'generator/other', version: 1 },
      ...nodes,
      'screen-a': nodes['screen-a'] ?? { type: 'output/screen', version: 1 },
    },
    wires,
  };
  const graphs = { main: graph, ...subgraphs };
  const assets = {
    photo: { path: 'photo.jpg', kind: 'image' },
    film: { path: 'film.webm', kind: 'video' },
    robot: { path: 'robot.glb', kind: 'model' },
  };
  const project = JSON.stringify({ format: 'scrim-project', version: 1, title: 'Test', graphs, assets });
  const loaded = needed(loadProject({ project, layout: null, sources: { ...PATTERNS, ...sources } }).output);
  const plain = compile({ project: loaded, library: LIBRARY, options });
  const fused = compile({ project: loaded, library: LIBRARY, options: { ...options, fuse: true } });
  const program = ({ output, diagnostics }: typeof plain): Program => {
    if (output === null) throw new Error(JSON.stringify(diagnostics));
    return output;
  };
  return { separate: program(plain), fused: program(fused), wires: fused.separate, folded: fused.folded ?? [] };
}

/** pattern → the effects in order → screen. Other layer inputs of an effect get the other pattern. */
export function chain(types: readonly string[], params: readonly object[] = [], options: CompileOptions = {}): CompiledTwins {
  const nodes = Object.fromEntries(
    types.map((type, i) => [`e-${i}`, { type, version: definitionOf(type).version, params: params[i] ?? {} }]),
  );
  const wires = types.flatMap((type, i) => {
    const [first, ...others] = layerPorts(type);
    const before = i === 0 ? 'pattern-a' : `e-${i - 1}`;
    return [`${before}.layer -> e-${i}.${first}`, ...others.map((port) => `other-a.layer -> e-${i}.${port}`)];
  });
  return twins(nodes, [...wires, `e-${types.length - 1}.layer -> screen-a.layer`], {}, options);
}

/** Effects in order; each reads at its inputs some of the four latest layers, of which the first two are patterns. */
export type GraphPlan = readonly (readonly [type: string, inputs: readonly number[]])[];

/**
 * Many graphs in one project, each with patterns of its own and a viewed layer at its end, so that they share a page, a player and all
 * shaders of single effects. The names of the viewed layers sort like the plans.
 */
export function manyGraphs(plans: readonly GraphPlan[]): Twins {
  const nodes: Record<string, object> = {};
  const wires: string[] = [];
  const taps = plans.map((plan, i) => {
    const graph = `g${String(i).padStart(3, '0')}`;
    const layers = [`${graph}-pattern`, `${graph}-other`];
    nodes[`${graph}-pattern`] = { type: 'generator/pattern', version: 1 };
    nodes[`${graph}-other`] = { type: 'generator/other', version: 1 };
    for (const [type, inputs] of plan) {
      const id = `${graph}-e${layers.length}`;
      nodes[id] = { type, version: versionOf(type) };
      const latest = layers.slice(-4);
      wires.push(...portsOf(type).map((port, k) => `${latest[(inputs[k] ?? 0) % latest.length]}.layer -> ${id}.${port}`));
      layers.push(id);
    }
    return `${layers.at(-1)}.layer`;
  });
  return twins(nodes, [...wires, 'pattern-a.layer -> screen-a.layer'], EXACT_SOURCES, { taps });
}

export function versionOf(type: string): number {
  return type in EXACT_EFFECTS ? 1 : definitionOf(type).version;
}

function portsOf(type: string): readonly string[] {
  return type in EXACT_EFFECTS ? ['inputImage'] : layerPorts(type);
}

/** Parts of all ordered pairs of effects. In each part, each effect is before and after others. */
export const PAIR_PARTS = 20;

/** The parts that `npm test` draws; the slow suite draws others. */
export const QUICK_PAIR_PARTS = [0, 10];

/** One part of all ordered pairs of effects, as graphs. */
export function pairsOfEffects(part: number): GraphPlan[] {
  return pairsWhere((i, k) => (i * 7 + k * 3) % PAIR_PARTS === part);
}

/** All ordered pairs with an effect whose shader the last commit or the working tree changes; none outside of a repository. */
export function pairsOfChangedEffects(): GraphPlan[] {
  const { stdout } = spawnSync('git', ['diff', '--name-only', 'HEAD~1', '--', ':/shader-library'], {
    cwd: import.meta.dirname,
    encoding: 'utf8',
  });
  const changed = new Set((stdout ?? '').split('\n').map((path) => basename(path, '.fs')));
  const isChanged = (i: number) => changed.has(basename(EFFECTS[i] ?? ''));
  return pairsWhere((i, k) => isChanged(i) || isChanged(k));
}

function pairsWhere(isWanted: (first: number, second: number) => boolean): GraphPlan[] {
  return EFFECTS.flatMap((first, i) =>
    EFFECTS.flatMap((second, k): GraphPlan[] =>
      isWanted(i, k)
        ? [
            [
              [first, [0, 1]],
              [second, [2, 1]],
            ],
          ]
        : [],
    ),
  );
}

export function definitionOf(type: string): NodeDefinition {
  return needed(LIBRARY.definition(type));
}

/** The params with which an effect of the library changes nothing, as its header says; null if it does not. */
export function identityOf(type: string): Readonly<Record<string, number | readonly number[]>> | null {
  const { lowering } = definitionOf(type);
  const source = lowering.kind === 'image' ? LIBRARY.shader(lowering.shader) : undefined;
  const inputs = source === undefined ? [] : (readIsf(source, type).output?.inputs ?? []);
  const identities = inputs.flatMap(({ name, identity }) => (identity === null ? [] : [[name, identity] as const]));
  if (identities.length === 0) return null;
  return Object.fromEntries(identities.map(([name, identity]) => [name, identity.length === 1 ? (identity[0] ?? 0) : identity]));
}

export function layerPorts(type: string): string[] {
  const { inputs } = definitionOf(type);
  return Object.keys(inputs).filter((port) => inputs[port]?.type === 'layer');
}

export function passes({ operations }: Program): PassOperation[] {
  return operations.filter((operation): operation is PassOperation => operation.kind === 'pass');
}

/** Effects that convert layers, so they cannot follow or precede every other effect. */
const CONVERTERS = new Set(['filter/to-scene', 'filter/tone-map']);

/** Every effect of the library that passes draw. */
export const EFFECTS: readonly string[] = [...LIBRARY.types()]
  .filter((type) => {
    const { lowering, inputs } = definitionOf(type);
    if (CONVERTERS.has(type)) return false;
    const isEffect = type.startsWith('filter/') || type.startsWith('operator/');
    const needs = Object.values(inputs).some((port) => port.type !== 'layer' && port.required);
    return isEffect && lowering.kind === 'image' && !needs && layerPorts(type).length > 0;
  })
  .sort();

function needed<T>(found: T | null | undefined): T {
  if (found === null || found === undefined) throw new Error('It is missing.');
  return found;
}
