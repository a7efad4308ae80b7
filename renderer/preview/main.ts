import { createBrowserClock } from '../../export/runtime/clock.ts';
import { waitForEditor } from './connect.ts';
import { createTheatre } from './theatre.ts';

async function main(): Promise<void> {
  const screen = document.getElementById('room');
  if (!screen) throw new Error('The page has no #room.');
  const editor = await waitForEditor(window);
  const theatre = createTheatre({ parent: document.body, screen, clock: createBrowserClock(), send: editor.send });
  window.addEventListener('resize', theatre.resized);
  editor.listen(theatre.take);
  editor.send({ kind: 'ready' });
}

void main();
