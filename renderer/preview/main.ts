import { createBrowserClock } from '../../export/runtime/clock.ts';
import { waitForEditor } from './connect.ts';
import { createFilm } from './film.ts';
import { createTheatre } from './theatre.ts';

async function main(): Promise<void> {
  const screen = document.getElementById('room');
  if (!screen) throw new Error('The page has no #room.');
  const editor = await waitForEditor(window);
  const theatre = createTheatre({ parent: document.body, screen, clock: createBrowserClock(), send: editor.send });
  window.addEventListener('resize', theatre.resized);
  const film = createFilm(editor.send);
  editor.listen((message) => {
    if (!film.take(message)) theatre.take(message);
  });
  editor.send({ kind: 'ready' });
}

void main();
