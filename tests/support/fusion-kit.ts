import { type CompileOptions, createCompiler } from '../../export/compiler/compile.ts';
import type { SeparateWire } from '../../export/compiler/schedule/fuse/separate-wire.ts';
import { loadProject } from '../../export/graph/load.ts';
import type { PassOperation, Program } from '../../export/program/program.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { LIBRARY } from './library.ts';

/** Colors that change from pixel to pixel and over large areas, of every alpha. Two of them, so that mixing them shows. */
const PATTERNS = {
  'pattern.fs': pattern('0.0'),
  'other.fs': pattern('0.37'),
};

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

/** Compiles nodes and wires with and without fusion. */
export function twins(
  nodes: Readonly<Record<string, object>>,
  wires: readonly string[],
  sources: Readonly<Record<string, string>> = {},
  options: CompileOptions = {},
  subgraphs: Readonly<Record<string, object>> = {},
): Twins {
  const graph = {
    nodes: {
      'pattern-a': { type: 'generator/pattern', version: 1 },
      'other-a': { type: 'generator/other', version: 1 },
      ...nodes,
      'screen-a': { type: 'output/screen', version: 1 },
    },
    wires,
  };
  const project = JSON.stringify({ format: 'scrim-project', version: 1, title: 'Test', graphs: { main: graph, ...subgraphs } });
  const loaded = needed(loadProject({ project, layout: null, sources: { ...PATTERNS, ...sources } }).output);
  const plain = compile({ project: loaded, library: LIBRARY, options });
  const fused = compile({ project: loaded, library: LIBRARY, options: { ...options, fuse: true } });
  const program = ({ output, diagnostics }: typeof plain): Program => {
    if (output === null) throw new Error(JSON.stringify(diagnostics));
    return output;
  };
  return { separate: program(plain), fused: program(fused), wires: fused.separate };
}

/** pattern → the effects in order → screen. Other layer inputs of an effect get the other pattern. */
export function chain(types: readonly string[], params: readonly object[] = []): Twins {
  const nodes = Object.fromEntries(
    types.map((type, i) => [`e-${i}`, { type, version: definitionOf(type).version, params: params[i] ?? {} }]),
  );
  const wires = types.flatMap((type, i) => {
    const [first, ...others] = layerPorts(type);
    const before = i === 0 ? 'pattern-a' : `e-${i - 1}`;
    return [`${before}.layer -> e-${i}.${first}`, ...others.map((port) => `other-a.layer -> e-${i}.${port}`)];
  });
  return twins(nodes, [...wires, `e-${types.length - 1}.layer -> screen-a.layer`]);
}

export function definitionOf(type: string): NodeDefinition {
  return needed(LIBRARY.definition(type));
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
