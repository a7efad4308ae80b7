import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { createCompiler } from '../../export/compiler/compile.ts';
import { inputOf, takesSeveral } from '../../export/graph/library/node-interface.ts';
import type { Binding, Graph, GraphNode, ProjectLogic, Wire } from '../../export/graph/project.ts';
import { sortWires } from '../../export/graph/wires.ts';
import type { Operation, Program } from '../../export/program/program.ts';
import { type NodeDefinition, type ParamDefinition, paramWireType } from '../../nodes/kit/definition.ts';
import { conversion, VALUE_SIZES } from '../../nodes/kit/wire-types.ts';
import { TEST_LIBRARY as library } from '../support/test-library.ts';
import { programFaults } from './program-faults.ts';

const TYPES = [...library.types()].filter((type) => type !== 'output/screen').map((type) => library.definition(type) as NodeDefinition);

/** Numbers that choose node types and wires; what they cannot choose (a required port that nothing fits) drops the node. */
const plans = fc.array(fc.tuple(fc.nat(TYPES.length - 1), fc.array(fc.noBias(fc.nat(1000)), { minLength: 6, maxLength: 6 }), fc.nat(9)), {
  minLength: 6,
  maxLength: 30,
});

/** Some params move by themselves: by an expression or a track of as many numbers as they hold. */
function bindingOf(param: ParamDefinition, choice: number): Binding | null {
  const type = paramWireType(param);
  if (type === undefined || type === 'text') return null;
  const size = VALUE_SIZES[type];
  const parts = Array.from({ length: size }, (_, i) => (i === 0 ? 'sin(time)' : `0.${i}`));
  if (choice % 5 === 1) return { expression: size === 1 ? (parts[0] ?? '') : `[${parts.join(', ')}]` };
  if (choice % 5 !== 2 || type === 'toggle' || param.type === 'choice') return null;
  const value = size === 1 ? 0.5 : new Array<number>(size).fill(0.5);
  return { track: { keys: [{ timeS: choice, value, easing: 'ease-in' }], repeat: 'loop' } };
}

type Plan = readonly (readonly [type: number, choices: readonly number[], state: number])[];

function graphOf(plan: Plan): Graph {
  const nodes: Record<string, GraphNode> = {};
  const wires: Wire[] = [];
  const outputs: { readonly from: Wire['from']; readonly type: NodeDefinition['outputs'][string]['type'] }[] = [];
  const add = (id: string, definition: NodeDefinition, choices: readonly number[], muted: boolean) => {
    const mine: Wire[] = [];
    const ports = [...Object.keys(definition.inputs), ...Object.keys(definition.params)];
    for (const [index, port] of ports.entries()) {
      const input = inputOf(definition, port);
      if (!input) continue;
      const fitting = outputs.filter(({ type }) => conversion(type, input.type) !== 'none');
      const choice = choices[index % choices.length] ?? 0;
      const required = input.kind === 'port' && input.port.required;
      if (required && fitting.length === 0) return;
      if (fitting.length === 0 || (!required && choice % 3 === 0)) continue;
      const picked = takesSeveral(input) ? [choice, choice + 1] : [choice];
      // From the newest few, so that most of the graph is connected.
      const sources = new Set(picked.map((number) => fitting[fitting.length - 1 - (number % Math.min(4, fitting.length))]));
      for (const source of sources) if (source) mine.push({ from: source.from, to: { node: id, port } });
    }
    const wired = new Set(mine.map(({ to }) => to.port));
    const params = Object.fromEntries(
      Object.entries(definition.params).flatMap(([name, param], index) => {
        const binding = wired.has(name) ? null : bindingOf(param, choices[index % choices.length] ?? 0);
        return binding ? [[name, binding]] : [];
      }),
    );
    nodes[id] = { type: definition.type, version: definition.version, params, ...(muted ? { muted } : {}) };
    wires.push(...mine);
    for (const [port, { type }] of Object.entries(definition.outputs)) outputs.push({ from: { node: id, port }, type });
  };
  plan.forEach(([type, choices, state], index) => {
    const definition = TYPES[type];
    if (definition) add(`n-${index}`, definition, choices, state === 0 && Object.keys(definition.inputs).length > 0);
  });
  add('video-z', library.definition('source/camera-video') as NodeDefinition, [], false);
  add(
    'screen-z',
    library.definition('output/screen') as NodeDefinition,
    [outputs.filter(({ type }) => type === 'layer').length - 2],
    false,
  );
  return { nodes, wires: sortWires(wires), exposed: { inputs: [], outputs: [] } };
}

function projectOf(main: Graph): ProjectLogic {
  return { title: '', page: { description: '', language: 'en' }, graphs: { main }, sources: {}, assets: {} };
}

const { compile } = createCompiler();

/** Null where a muted source left a port without anything. */
function compiled(graph: Graph, taps: readonly string[] = [], fuse = false): Program | null {
  const { output, diagnostics } = compile({ project: projectOf(graph), library, options: { taps, fuse } });
  const errors = diagnostics.filter(({ severity }) => severity === 'error');
  if (output === null && errors.every(({ code }) => code === 'SCR015')) return null;
  expect(errors).toEqual([]);
  return output;
}

const layersOf = (graph: Graph) =>
  Object.entries(graph.nodes).flatMap(([id, { type }]) =>
    Object.entries(library.definition(type)?.outputs ?? {}).flatMap(([port, output]) => (output.type === 'layer' ? [`${id}.${port}`] : [])),
  );

/** Indices of shaders differ where there are more of them, and viewed layers have a texture for each view, so views do not share them. */
const comparable = ({ shaders }: Program, operation: Operation) =>
  operation.kind === 'pass' ? { ...operation, shader: shaders[operation.shader]?.id, sameForViews: null } : operation;

describe('any graph', () => {
  test('compiles to a program that can be played in its order, and that JSON can hold', () => {
    let compositions = 0;
    let moved = 0;
    let shared = 0;
    fc.assert(
      fc.property(plans, (plan) => {
        const program = compiled(graphOf(plan));
        if (program === null) return;
        if (program.presentation.mode === 'composed') compositions++;
        if (program.operations.some((operation) => 'type' in operation && operation.type.startsWith('binding/'))) moved++;
        if (program.resources.some((resource) => resource.kind === 'target' && resource.shares !== undefined)) shared++;
        expect(programFaults(program)).toEqual([]);
        expect(JSON.parse(JSON.stringify(program))).toEqual(program);
      }),
      { seed: 3, numRuns: 300 },
    );
    expect(compositions).toBeGreaterThan(30);
    expect(moved).toBeGreaterThan(30);
    expect(shared).toBeGreaterThan(10);
  });

  test('compiles to a program that can be played with fused passes, too', () => {
    let fewer = 0;
    fc.assert(
      fc.property(plans, (plan) => {
        const graph = graphOf(plan);
        const fused = compiled(graph, [], true);
        const separate = compiled(graph);
        if (fused === null || separate === null) return;
        expect(programFaults(fused)).toEqual([]);
        expect(fused.operations.length).toBeLessThanOrEqual(separate.operations.length);
        if (fused.operations.length < separate.operations.length) fewer++;
        expect(fused.slots).toEqual(separate.slots);
      }),
      { seed: 3, numRuns: 200 },
    );
    expect(fewer).toBeGreaterThan(12);
  });

  test('shows the same picture while all of its layers are looked at', () => {
    fc.assert(
      fc.property(plans, (plan) => {
        const graph = graphOf(plan);
        const plain = compiled(graph);
        const tapped = compiled(graph, layersOf(graph));
        if (plain === null || tapped === null) return expect(tapped).toBe(plain);
        expect(programFaults(tapped)).toEqual([]);
        const ids = new Set(plain.operations.map(({ id }) => id));
        const same = tapped.operations.filter(({ id }) => ids.has(id)).map((operation) => comparable(tapped, operation));
        const inKind = (made: readonly { readonly id: string }[]) => new Map(made.map((operation) => [operation.id, operation]));
        expect(inKind(same)).toEqual(inKind(plain.operations.map((operation) => comparable(plain, operation))));
        const onScreen = (operations: readonly { readonly id: string; readonly target?: string }[]) =>
          operations.filter(({ target }) => target === 'screen').map(({ id }) => id);
        expect(onScreen(tapped.operations)).toEqual(onScreen(plain.operations));
        expect(tapped.presentation).toEqual(plain.presentation);
        expect(tapped.needs.map(({ capability }) => capability)).toEqual(
          expect.arrayContaining(plain.needs.map(({ capability }) => capability)),
        );
        expect(tapped.slots.params).toMatchObject(plain.slots.params);
      }),
      { seed: 4, numRuns: 200 },
    );
  });

  test('gives the same program whatever order its nodes were added in', () => {
    fc.assert(
      fc.property(plans, (plan) => {
        const graph = graphOf(plan);
        const backwards = { ...graph, nodes: Object.fromEntries(Object.entries(graph.nodes).reverse()) };
        expect(JSON.stringify(compiled(backwards))).toBe(JSON.stringify(compiled(graph)));
      }),
      { seed: 5, numRuns: 100 },
    );
  });
});
