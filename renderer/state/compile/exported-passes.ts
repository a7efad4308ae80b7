import { FOLD_REASONS, type FoldedNode } from '../../../export/compiler/fold/folded-node.ts';
import { SEPARATE_REASONS, type SeparateWire } from '../../../export/compiler/schedule/fuse/separate-wire.ts';
import type { Program } from '../../../export/program/program.ts';
import type { Editor } from '../editor/editor.ts';
import { type CompilerWorker, createCompilerLink } from './compiler-link.ts';

/** The program of the exported page, with the wires between passes that are not fused. */
export interface ExportedProgram {
  readonly program: Program;
  readonly separate: readonly SeparateWire[];
  readonly folded: readonly FoldedNode[];
}

/** What the passes of the exported page do with a node. Nodes have their ids in the program: `outer/inner`. */
export interface NodePasses {
  /** The other nodes of each pass that draws the node. Empty: no pass draws it. */
  readonly passes: readonly (readonly string[])[];
  /** The scenes whose materials compute the node. */
  readonly inMaterialsOf: readonly string[];
  /** Layers that the node draws to a texture or reads from one, with the node that reads each. */
  readonly separate: readonly { readonly layer: string; readonly reader: string; readonly reason: string }[];
  /** Why the page leaves the node out; null if it does not. */
  readonly folded: { readonly reason: string; readonly instead: string | null } | null;
}

/**
 * Compiles the project as for an export, again after each change, until the returned function is called. Without a program, because of
 * mistakes in the project, the last one stays.
 */
export function watchExportedProgram(
  { document }: Pick<Editor, 'document'>,
  worker: CompilerWorker,
  show: (exported: ExportedProgram) => void,
): () => void {
  const link = createCompilerLink(worker, ({ program, separate = [], folded = [] }) => {
    if (program !== null) show({ program, separate, folded });
  });
  const compile = () => {
    const { revision, project } = document.getState();
    const { layout: _, ...logic } = project;
    link.request({ revision, project: logic, taps: [], thumbnails: [], exported: true });
  };
  const stop = document.subscribe((state, before) => {
    if (state.project !== before.project) compile();
  });
  compile();
  return () => {
    stop();
    link.dispose();
  };
}

/** Finds what the passes of the exported page do with a node. */
export function passesOf({ program, separate, folded }: ExportedProgram, node: string): NodePasses {
  const left = folded.find((one) => one.node === node);
  const passes = program.operations.flatMap((operation) => {
    if (operation.kind !== 'pass') return [];
    const nodes = operation.nodes ?? [operation.node];
    return nodes.includes(node) ? [nodes.filter((other) => other !== node)] : [];
  });
  return {
    passes,
    inMaterialsOf: program.operations.flatMap((operation) =>
      'effects' in operation && operation.effects?.nodes.includes(node) ? [operation.node] : [],
    ),
    separate: separate
      .filter((wire) => wire.node === node || wire.resource.startsWith(`${node}.`))
      .map(({ resource, node: reader, reason }) => ({ layer: resource, reader, reason: SEPARATE_REASONS[reason] })),
    folded: left === undefined ? null : { reason: FOLD_REASONS[left.reason], instead: left.instead },
  };
}

export function startExportCompiler(): CompilerWorker {
  return new Worker(new URL('./compile.worker.ts', import.meta.url), { type: 'module', name: 'export compiler' });
}
