import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';

/** Diagnostics of the running program by node; the host is notified of each change. */
export interface DiagnosticsBoard {
  /** Adds a diagnostic. Equal ones are added once, so a node may report in every frame. */
  report(node: string, diagnostic: Omit<Diagnostic, 'nodeId'>): void;
  clear(node: string): void;
}

export function createDiagnosticsBoard(onChange: (diagnostics: readonly Diagnostic[]) => void): DiagnosticsBoard {
  const byNode = new Map<string, Diagnostic[]>();
  const tell = (): void => onChange([...byNode.values()].flat());
  return {
    report: (node, diagnostic) => {
      const known = byNode.get(node) ?? [];
      const { code, port, message } = diagnostic;
      if (known.some((d) => d.code === code && d.port === port && d.message === message)) return;
      byNode.set(node, [...known, { ...diagnostic, nodeId: node }]);
      tell();
    },
    clear: (node) => {
      if (byNode.delete(node)) tell();
    },
  };
}
