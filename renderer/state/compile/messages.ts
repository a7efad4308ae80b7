import type { ShaderAbove } from '../../../export/compiler/compile.ts';
import type { ProjectLogic } from '../../../export/graph/project.ts';
import type { Program } from '../../../export/program/program.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';

export interface CompileRequest {
  readonly revision: number;
  readonly project: ProjectLogic;
  /** Layers that the program keeps for viewing; see `CompileOptions`. */
  readonly taps: readonly string[];
}

export interface CompileAnswer {
  readonly revision: number;
  readonly program: Program | null;
  readonly diagnostics: readonly Diagnostic[];
  /** Without a program: texts above mistakes, for a driver; see `Compiled`. */
  readonly above: readonly ShaderAbove[];
  readonly tookMs: number;
}
