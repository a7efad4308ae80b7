import type { Project } from '../../export/graph/project.ts';
import type { Program } from '../../export/program/program.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';

/** What the compiler needs of a project: all but where things stand on the canvas. */
export type CompilerInput = Omit<Project, 'layout'>;

export interface CompileRequest {
  readonly revision: number;
  readonly project: CompilerInput;
}

export interface CompileAnswer {
  readonly revision: number;
  readonly program: Program | null;
  readonly diagnostics: readonly Diagnostic[];
  readonly tookMs: number;
}
