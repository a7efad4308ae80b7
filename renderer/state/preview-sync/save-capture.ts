import type { FromPreview } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { titleOfName } from '../editor/library.ts';
import { addToast } from '../editor/ui.ts';

type Captured = Extract<FromPreview, { kind: 'captured' }>;

/** Saves a screenshot or video of the preview to the downloads. */
export function saveCapture(editor: Editor, { what, file }: Captured): void {
  if (what === 'video') editor.preview.setState({ recording: false });
  if (file === null) {
    const text = what === 'video' ? 'The video is empty. This browser cannot record the preview.' : 'The preview shows nothing to capture.';
    addToast(editor.ui, { tone: 'error', text });
    return;
  }
  const { title } = editor.document.getState().project;
  const name = `${title.trim() === '' ? titleOfName(what) : title}.${endingOf(file.type)}`;
  editor.keepFile(file, name);
  addToast(editor.ui, { tone: 'success', text: `Saved ${name} to your downloads.` });
}

function endingOf(type: string): string {
  if (type.startsWith('image/')) return 'png';
  return type.startsWith('video/mp4') ? 'mp4' : 'webm';
}
