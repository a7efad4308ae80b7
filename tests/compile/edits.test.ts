import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { compile, createCompiler } from '../../export/compiler/compile.ts';
import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import { newProject } from '../../export/graph/new-project.ts';
import { type Graph, MAIN_GRAPH, type Project } from '../../export/graph/project.ts';
import { parseWire } from '../../export/graph/wires.ts';
import { LIBRARY as library } from '../support/library.ts';

/** A compiler that has compiled earlier states of a project gives what a new one gives. */

const TYPES: Readonly<Record<string, string>> = {
  'video-a': 'source/camera-video',
  'photo-a': 'source/image-file',
  'own-a': 'filter/own',
  'own-b': 'filter/own',
  'deep-a': 'filter/deep',
  'blur-a': 'filter/gaussian-blur',
  'box-a': 'objects/primitive',
  'ink-a': 'technique/ink',
  'scene-a': 'layer/scene',
  'over-a': 'operator/over',
  'made-a': 'generator/made',
  'mix-a': 'operator/blend',
  'screen-a': 'output/screen',
};

const WIRES = [
  'video-a.layer -> own-a.inputImage',
  'own-a.layer -> blur-a.inputImage',
  'blur-a.layer -> own-b.inputImage',
  'box-a.objects -> scene-a.objects',
  'scene-a.layer -> deep-a.inputImage',
  'deep-a.layer -> over-a.top',
  'own-b.layer -> over-a.bottom',
  'over-a.layer -> screen-a.layer',
];

const header = (inputs: string, more = '') => `/*{ "ISFVSN": "2", "DESCRIPTION": "Test."${more}, "INPUTS": [${inputs}] }*/\n`;
const IMAGE = '{ "NAME": "inputImage", "TYPE": "image" }';
const AMOUNT = '{ "NAME": "amount", "TYPE": "float", "MIN": 0, "MAX": 4, "DEFAULT": 1 }';
const main = (color: string) => `void main() { gl_FragColor = ${color}; }\n`;
const HERE = 'IMG_THIS_PIXEL(inputImage)';

/** Texts that a file may get: other colors, other reads, other headers, mistakes. */
const TEXTS: Readonly<Record<string, readonly string[]>> = {
  'own.fs': [
    ...[1, 2, 3].map((n) => header(IMAGE) + main(`${HERE} * ${n}.0`)),
    header(IMAGE) + main(`IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(1.0, 0.0))`),
    header(IMAGE) + main(`vec4(${HERE}.rgb, 1.0)`),
    header(IMAGE) + main('vec4(TIME)'),
    header(IMAGE) + main(`${HERE} * stray`),
    `${header(IMAGE)}uniform float stray;\n${main(`${HERE} * stray`)}`,
    header(`${IMAGE}, ${AMOUNT}`) + main(`${HERE} * amount`),
    header(`${IMAGE}, ${AMOUNT}`) + main(`${HERE} + amount`),
    header(IMAGE, ', "PASSES": [{ "TARGET": "half", "WIDTH": "$WIDTH / 2" }, {}]') +
      main(`${HERE} + IMG_NORM_PIXEL(half, isf_FragNormCoord)`),
    header(IMAGE) + main(`${HERE} *`),
    header('') + main(HERE),
  ],
  'own.vs': ['void main() { isf_vertShaderInit(); }\n', 'void main() { isf_vertShaderInit(); gl_Position.x += 0.5; }\n'],
  'deep.fs': [
    header(IMAGE) + main(HERE),
    header(IMAGE) + main(`vec4(LAYER_DEPTH(inputImage, isf_FragNormCoord))`),
    header(IMAGE) + main(`vec4(1.0 - LAYER_DEPTH(inputImage, isf_FragNormCoord))`),
  ],
  'made.fs': [header('') + main('vec4(isf_FragNormCoord, 0.0, 1.0)'), header('') + main('vec4(isf_FragNormCoord.yx, 0.0, 1.0)')],
  'ink.glsl': ['0.5', '0.25'].map(
    (gray) => `/*{ "DESCRIPTION": "Gray." }*/\nvec4 surface(const in Surface s) { return vec4(vec3(${gray}), 1.0); }\n`,
  ),
};

type Edit = (project: Project) => Project;

const withGraph =
  (edit: (graph: Graph) => Graph): Edit =>
  (project) => {
    const graph = project.graphs[MAIN_GRAPH] as Graph;
    return { ...project, graphs: { ...project.graphs, [MAIN_GRAPH]: edit(graph) } };
  };

const withNode = (id: string, edit: (node: Graph['nodes'][string]) => Graph['nodes'][string]): Edit =>
  withGraph((graph) => ({ ...graph, nodes: { ...graph.nodes, [id]: edit(graph.nodes[id] as Graph['nodes'][string]) } }));

const nodeId = fc.constantFrom(...Object.keys(TYPES).filter((id) => id !== 'screen-a'));
const text = fc
  .constantFrom(...Object.keys(TEXTS))
  .chain((file) => fc.constantFrom(...(TEXTS[file] ?? [])).map((source) => ({ file, source })));

/** Most edits are of texts, as while somebody types. */
const anyEdit: fc.Arbitrary<Edit> = fc.oneof(
  {
    weight: 8,
    arbitrary: text.map(
      ({ file, source }): Edit =>
        (project) => ({ ...project, sources: { ...project.sources, [file]: source } }),
    ),
  },
  { weight: 1, arbitrary: fc.constant<Edit>(({ sources: { 'own.vs': _, ...sources }, ...project }) => ({ ...project, sources })) },
  {
    weight: 2,
    arbitrary: fc
      .tuple(fc.constantFrom('blur-a.radius', 'over-a.opacity', 'own-a.amount', 'mix-a.amount'), fc.constantFrom(0, 0.5, 1, 7))
      .map(([address, value]): Edit => {
        const [id = '', param = ''] = address.split('.');
        return withNode(id, (node) => ({ ...node, params: { ...node.params, [param]: { value } } }));
      }),
  },
  { weight: 1, arbitrary: nodeId.map((id): Edit => withNode(id, (node) => ({ ...node, muted: node.muted !== true }))) },
  { weight: 1, arbitrary: nodeId.map((id): Edit => withNode(id, (node) => ({ ...node, unfused: node.unfused !== true }))) },
  {
    weight: 1,
    arbitrary: fc
      .nat(WIRES.length - 1)
      .map((i): Edit => withGraph((graph) => ({ ...graph, wires: graph.wires.filter((_, at) => at !== i) }))),
  },
  {
    weight: 1,
    arbitrary: fc
      .constantFrom('made-a.layer -> own-a.inputImage', 'photo-a.layer -> own-b.inputImage', 'ink-a.technique -> box-a.technique', ...WIRES)
      .map((wire): Edit => {
        const { from, to } = wireOf(wire);
        return withGraph((graph) => ({
          ...graph,
          wires: [...graph.wires.filter((other) => other.to.node !== to.node || other.to.port !== to.port), { from, to }],
        }));
      }),
  },
  { weight: 1, arbitrary: fc.constant<Edit>((project) => structuredClone(project)) },
);

const anyOptions: fc.Arbitrary<CompileOptions> = fc.oneof(
  { weight: 6, arbitrary: fc.constant({ loopBudget: true, taps: ['own-a.layer'] }) },
  {
    weight: 1,
    arbitrary: fc.constantFrom<CompileOptions>(
      {},
      { fuse: true },
      { fuse: true, fold: true },
      { reportUnused: true },
      { sourceMaps: false },
    ),
  },
);

function wireOf(wire: string) {
  const parsed = parseWire(wire);
  if (parsed === null) throw new Error(`${wire} is no wire.`);
  return parsed;
}

function start(): Project {
  const nodes = Object.fromEntries(
    Object.entries(TYPES).map(([id, type]) => [id, { type, version: library.definition(type)?.version ?? 1, params: {} }]),
  );
  const graph: Graph = { nodes, wires: WIRES.map(wireOf), exposed: { inputs: [], outputs: [] } };
  const sources = Object.fromEntries(Object.entries(TEXTS).flatMap(([file, [first = '']]) => (file === 'own.vs' ? [] : [[file, first]])));
  return { ...newProject('Edits'), sources, graphs: { [MAIN_GRAPH]: graph } };
}

describe('after an edit', () => {
  test('a compiler gives the program and the diagnostics that a new one gives, at 500 random edits', () => {
    const counts = { programs: 0, errors: 0, kept: 0 };
    fc.assert(
      fc.property(fc.array(fc.tuple(anyEdit, anyOptions), { minLength: 10, maxLength: 10 }), (edits) => {
        const known = createCompiler();
        let project = start();
        let slots: unknown;
        for (const [edit, options] of edits) {
          project = edit(project);
          const compiled = known.compile({ project, library, options });
          expect(compiled).toEqual(compile({ project, library, options }));
          if (compiled.output === null) counts.errors++;
          else counts.programs++;
          if (compiled.output && compiled.output.slots === slots) counts.kept++;
          slots = compiled.output?.slots ?? slots;
        }
      }),
      { numRuns: 50, seed: 19 },
    );
    // Enough of each kind: programs, mistakes, and programs of which all but a text was kept.
    expect(Math.min(counts.programs, counts.errors, counts.kept)).toBeGreaterThan(40);
  });

  test('of a shader, only that is linked again', () => {
    const { compile: again } = createCompiler();
    const withText = (source: string) => ({ ...start(), sources: { ...start().sources, 'own.fs': source } });
    const [first = '', second = '', , moved = ''] = TEXTS['own.fs'] ?? [];
    const slotsOf = (source: string) => again({ project: withText(source), library }).output?.slots;
    const slots = slotsOf(first);
    // The schedule is kept, and its slots with it.
    expect(slotsOf(second)).toBe(slots);
    // A shader that reads other pixels may need another filter of its texture.
    expect(slotsOf(moved)).not.toBe(slots);
  });
});
