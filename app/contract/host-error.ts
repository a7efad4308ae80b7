import type { HostDiagnostic } from './contract.ts';

/** A refusal: the user, the path or the page asked for something that the host does not do. */
export class HostError extends Error {
  override readonly name = 'HostError';
  readonly diagnostic: HostDiagnostic;

  constructor(diagnostic: HostDiagnostic) {
    super(diagnostic.message);
    this.diagnostic = diagnostic;
  }
}

/** An answer as it crosses a process border, where errors lose their class. */
export type Answer<T> = { readonly output: T } | { readonly diagnostic: HostDiagnostic };

export function outputOf<T>(answer: Answer<T>): T {
  if ('diagnostic' in answer) throw new HostError(answer.diagnostic);
  return answer.output;
}
