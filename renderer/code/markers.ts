import { editor, MarkerSeverity } from 'monaco-editor/editor';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';

const OWNER = 'scrim';
const SEVERITIES = { error: MarkerSeverity.Error, warning: MarkerSeverity.Warning, info: MarkerSeverity.Info } as const;

export function markDiagnostics(model: editor.ITextModel, diagnostics: readonly Diagnostic[]): void {
  editor.setModelMarkers(
    model,
    OWNER,
    diagnostics.map((diagnostic) => markerOf(model, diagnostic)),
  );
}

/** Marks from the column to the end of its word, or the whole line if the column is unknown. */
function markerOf(model: editor.ITextModel, { line, column, message, fix, severity, code }: Diagnostic): editor.IMarkerData {
  const startLineNumber = Math.min(Math.max(line ?? 1, 1), model.getLineCount());
  const startColumn = column ?? model.getLineFirstNonWhitespaceColumn(startLineNumber);
  const word = column === undefined ? null : model.getWordAtPosition({ lineNumber: startLineNumber, column: startColumn });
  return {
    severity: SEVERITIES[severity],
    message: fix === undefined ? message : `${message}\n${fix}`,
    code,
    startLineNumber,
    startColumn,
    endLineNumber: startLineNumber,
    endColumn: column === undefined ? model.getLineMaxColumn(startLineNumber) : (word?.endColumn ?? startColumn + 1),
  };
}
