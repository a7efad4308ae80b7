import type { CaptureReport } from '../../../export/captures/report/capture-report.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { photoBlob } from '../../../nodes/kit/photo-blob.ts';
import type { Editor } from '../editor/editor.ts';
import { bytesOf } from '../files/base64.ts';
import { asked } from './outside-run.ts';

/** What is known of a capture, or why it cannot be read. `path`: its `capture.json`. */
export function readCaptureReport(editor: Editor, path: string): Promise<CaptureReport | Diagnostic | null> {
  return asked(editor, (handle) => editor.host.call('capture.report', { handle, path }));
}

/** Reads a photograph of a capture, or why it cannot be read. `path`: that in the project. */
export function readPhotograph(editor: Editor, path: string): Promise<Blob | Diagnostic | null> {
  return asked(editor, async (handle) => photoBlob(path, bytesOf((await editor.host.call('asset.read', { handle, path })).base64)));
}

/** Shows what is known of a capture. `note` stands above it. */
export function showCaptureReport({ ui }: Editor, path: string, note?: string): void {
  ui.setState({ dialog: { kind: 'capture-report', path, ...(note !== undefined && { note }) } });
}
