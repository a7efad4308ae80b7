import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';

/** What is wrong with the running program, node by node; told to the host whenever it changes. */
export interface DiagnosticsBoard {
  /** The same report again changes nothing, so a node may report every frame. */
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
