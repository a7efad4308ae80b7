import type { FromPreview } from '../../preview-protocol.ts';
import type { Editor } from '../editor/editor.ts';
import { titleOfName } from '../editor/library.ts';
import { addToast } from '../editor/ui.ts';

type Captured = Extract<FromPreview, { kind: 'captured' }>;

/** Gives a picture or a video of the preview to the person, as browsers give files. */
export function takeCapture(editor: Editor, { what, file }: Captured): void {
  if (what === 'video') editor.preview.setState({ recording: false });
  if (file === null) {
    const text = what === 'video' ? 'This browser recorded nothing.' : 'There is nothing in the preview to take a picture of.';
    addToast(editor.ui, { tone: 'error', text });
    return;
  }
  const { title } = editor.document.getState().project;
  const name = `${title.trim() === '' ? titleOfName(what) : title}.${endingOf(file.type)}`;
  editor.keepFile(file, name);
  addToast(editor.ui, { tone: 'success', text: `${name} is with your downloads.` });
}

function endingOf(type: string): string {
  if (type.startsWith('image/')) return 'png';
  return type.startsWith('video/mp4') ? 'mp4' : 'webm';
}
