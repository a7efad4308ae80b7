import type { HostDiagnostic } from './contract.ts';

/** The host rejected a call. The diagnostic says why. */
export class HostError extends Error {
  override readonly name = 'HostError';
  readonly diagnostic: HostDiagnostic;

  constructor(diagnostic: HostDiagnostic) {
    super(diagnostic.message);
    this.diagnostic = diagnostic;
  }
}

/** A result that can cross a process boundary, where errors lose their class. */
export type Answer<T> = { readonly output: T } | { readonly diagnostic: HostDiagnostic };

export function outputOf<T>(answer: Answer<T>): T {
  if ('diagnostic' in answer) throw new HostError(answer.diagnostic);
  return answer.output;
}
