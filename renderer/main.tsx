import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import { connectHost } from '../app/contract/connect-host.ts';
import { DEFINITIONS, SHADERS } from '../nodes/generated/definitions.gen.ts';
import { createPageClipboard } from './clipboard.ts';
import { pageClock } from './clock.ts';
import { downloadFile } from './download.ts';
import { pageRandom } from './random.ts';
import { App } from './shell/app.tsx';
import { runFromMenu } from './shell/menu-command.ts';
import { NoHost } from './shell/no-host.tsx';
import { openFilmFrame } from './stage/film-frame.ts';
import { createEditor } from './state/editor.ts';
import { createFeed } from './state/feed.ts';
import { keepRanges } from './state/kept-ranges.ts';
import { followMenus } from './state/menus.ts';
import { createPreferences, keepPreferences, loadPreferences } from './state/preferences.ts';
import { keepSizes, loadSizes } from './state/sizes.ts';
import { autosave, followHost, hasUnsavedWork, openFirst, start } from './state/start.ts';
import { followAppearance } from './ui/appearance.ts';
import './ui/theme.css';
import './ui/scale.css';

async function main(): Promise<void> {
  const element = document.getElementById('root');
  if (!element) throw new Error('The page has no #root.');
  const root = createRoot(element);
  const host = connectHost(window);
  if (host === null) {
    followAppearance(createPreferences(loadPreferences(localStorage)), window);
    root.render(<NoHost />);
    return;
  }
  const editor = createEditor({
    host,
    clock: pageClock,
    random: pageRandom,
    library: { definitions: DEFINITIONS, shaders: SHADERS },
    mac: navigator.platform.startsWith('Mac'),
    clipboard: createPageClipboard(navigator.clipboard),
    keepFile: (file, name) => downloadFile(pageClock, file, name),
    sizes: loadSizes(localStorage, window.innerWidth),
    preferences: loadPreferences(localStorage),
  });
  followAppearance(editor.preferences, window);
  keepPreferences(editor, localStorage);
  const worker = new Worker(new URL('./compile/compile.worker.ts', import.meta.url), { type: 'module', name: 'compiler' });
  const feed = createFeed(editor, worker);
  const { previewUrl, hasMenu } = await start(editor);
  editor.film.open = () => openFilmFrame(document, previewUrl);
  followHost(editor, (id) => runFromMenu(editor, id));
  if (hasMenu) followMenus(editor);
  autosave(editor);
  keepSizes(editor, localStorage);
  keepRanges(editor, localStorage);
  window.addEventListener('beforeunload', (event) => {
    if (hasUnsavedWork(editor)) event.preventDefault();
  });
  root.render(
    <StrictMode>
      <App editor={editor} feed={feed} previewUrl={previewUrl} />
    </StrictMode>,
  );
  await openFirst(editor);
}

void main();
