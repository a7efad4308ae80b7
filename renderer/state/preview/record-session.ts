import type { FromPreview } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { chosenSource } from '../editor/preview-state.ts';
import { addToast } from '../editor/ui.ts';
import { listSessions, showRefusal } from '../files/files.ts';

/** Ids of recorded sessions in the project, as the host gives them. */
const RECORDED = /^project\/recording-(\d+)$/;

/** Whether a session can be recorded or its recording stopped. The preview tells why a recording cannot be recorded again. */
export function canRecordSession({ document, preview }: Pick<Editor, 'document' | 'preview'>): boolean {
  const state = preview.getState();
  if (document.getState().open === null) return false;
  return state.sessionRecording === 'recording' || (state.sessionRecording === 'no' && chosenSource(state) !== null);
}

/** Starts to record where the visitor of the preview goes and what the visitor does, or stops it. */
export function toggleSessionRecording({ preview, transport }: Pick<Editor, 'preview' | 'transport'>): void {
  const { sessionRecording } = preview.getState();
  if (sessionRecording === 'filming') return;
  const on = sessionRecording === 'no';
  preview.setState({ sessionRecording: on ? 'recording' : 'filming' });
  transport.post({ kind: 'record-session', on, title: nextTitle(preview.getState()) });
}

function nextTitle({ sources }: { readonly sources: readonly { readonly id: string }[] }): string {
  const numbers = sources.map(({ id }) => Number(RECORDED.exec(id)?.[1] ?? 0));
  return `Recording ${Math.max(0, ...numbers) + 1}`;
}

/** Saves a session that the preview has recorded with the project, and lists it among the preview sources. */
export async function saveRecordedSession(editor: Editor, message: Extract<FromPreview, { kind: 'session-recorded' }>): Promise<void> {
  const { preview, document, host, ui } = editor;
  const { recorded, text } = message;
  // The preview cannot write files that nobody asked for.
  const wasAsked = preview.getState().sessionRecording !== 'no';
  const { open } = document.getState();
  if (recorded === null || open === null || !wasAsked) {
    preview.setState({ sessionRecording: 'no' });
    if (wasAsked && text !== '') addToast(ui, { tone: 'error', text });
    return;
  }
  try {
    const { session, content } = recorded;
    const { id } = await host.call('session.save', { handle: open.handle, session, files: [...recorded.files], content });
    await listSessions(editor);
    const title = preview.getState().sources.find((source) => source.id === id)?.title ?? id;
    addToast(ui, { tone: 'success', text: `Recorded “${title}”. Choose it as the preview source to replay it.` });
  } catch (error) {
    showRefusal(editor, error);
  } finally {
    preview.setState({ sessionRecording: 'no' });
  }
}
