import { compile } from '../../export/compiler/compile.ts';
import type { CompileOptions } from '../../export/compiler/compile-options.ts';
import type { DrawOperation, PassOperation, Program } from '../../export/program/program.ts';
import { formatDiagnostic } from '../../nodes/kit/diagnostics.ts';
import { TEST_LIBRARY as library } from '../support/test-library.ts';
import type { TestStudio } from '../support/test-studio.ts';

/** What tests ask of a program that a studio's project compiles to. */

export function program(studio: TestStudio, options: CompileOptions = {}): Program {
  const { output, diagnostics } = compile({ project: studio.project, library, options });
  if (output === null) throw new Error(diagnostics.map(formatDiagnostic).join('\n'));
  return output;
}

export function problems(studio: TestStudio, options: CompileOptions = {}) {
  const { diagnostics } = compile({ project: studio.project, library, options });
  return diagnostics.map(({ code, severity, nodeId, port }) => ({ code, severity, nodeId, port }));
}

export function ids({ operations }: Program, kind?: string): string[] {
  return operations.filter((operation) => kind === undefined || operation.kind === kind).map(({ id }) => id);
}

export function draws({ operations }: Program): DrawOperation[] {
  return operations.filter((operation): operation is DrawOperation => operation.kind === 'draw');
}

export function passes({ operations }: Program): PassOperation[] {
  return operations.filter((operation): operation is PassOperation => operation.kind === 'pass');
}

export function targets({ resources }: Program): string[] {
  return resources.filter(({ kind }) => kind === 'target').map(({ id }) => id);
}

export function asked({ needs }: Program): string[] {
  return needs.map(({ capability }) => capability);
}
