import { waitForEditor } from './connect.ts';
void waitForEditor(window).then((editor) => editor.send({ kind: 'ready' }));
