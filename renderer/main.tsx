import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import { connectHost } from '../app/contract/connect-host.ts';
import { DEFINITIONS, SHADERS } from '../nodes/generated/definitions.gen.ts';
import { pageClock } from './clock.ts';
import { watchDrags } from './drag-watch.ts';
import { createPageClipboard, downloadFile } from './page-services.ts';
import { guardPreviewInPage } from './preview-guard.ts';
import { createModelPage } from './preview-panel/model-page.ts';
import { openRenderPage } from './preview-panel/render-page.ts';
import { pageRandom } from './random.ts';
import { App } from './shell/app.tsx';
import { Logo } from './shell/logo.tsx';
import { runFromMenu } from './shell/menu-command.ts';
import { syncNativeMenus } from './state/commands/menus.ts';
import { createEditor } from './state/editor/editor.ts';
import { createPreferences, keepPreferences, loadPreferences } from './state/editor/preferences.ts';
import { keepExports } from './state/preferences/kept-exports.ts';
import { keepViews } from './state/preferences/kept-views.ts';
import { keepLayout, loadLayout } from './state/preferences/panel-layout.ts';
import { keepRanges } from './state/preview/kept-ranges.ts';
import { createPreviewSync } from './state/preview-sync/preview-sync.ts';
import { autosave, handleHostEvents, hasUnsavedWork, keepOpenPath, openFirst, start } from './state/start.ts';
import { followAppearance } from './ui/appearance.ts';
import './shell/no-host.css';
import './ui/theme.css';
import './ui/scale.css';

async function main(): Promise<void> {
  const element = document.getElementById('root');
  if (!element) throw new Error('The page has no #root.');
  const root = createRoot(element);
  const connection = await connectHost(window);
  if ('why' in connection) {
    followAppearance(createPreferences(loadPreferences(localStorage)), window);
    root.render(<NoHost why={connection.why} />);
    return;
  }
  const { host } = connection;
  const editor = createEditor({
    host,
    clock: pageClock,
    random: pageRandom,
    library: { definitions: DEFINITIONS, shaders: SHADERS },
    mac: navigator.platform.startsWith('Mac'),
    clipboard: createPageClipboard(navigator.clipboard),
    keepFile: (file, name) => downloadFile(pageClock, file, name),
    ...loadLayout(localStorage, window.innerWidth, window.innerHeight),
    preferences: loadPreferences(localStorage),
  });
  followAppearance(editor.preferences, window);
  keepPreferences(editor, localStorage);
  const worker = new Worker(new URL('./state/compile/compile.worker.ts', import.meta.url), { type: 'module', name: 'compiler' });
  const previewSync = createPreviewSync(editor, worker);
  guardPreviewInPage(editor);
  watchDrags(
    window,
    (ms) => new Promise((done) => pageClock.after(ms, done)),
    (on) => previewSync.send({ kind: 'dragging', on }),
  );
  const { previewUrl, hasMenu } = await start(editor);
  editor.renderPage.open = () => openRenderPage(document, previewUrl);
  editor.models.draw = createModelPage(document, previewUrl);
  handleHostEvents(editor, (id) => runFromMenu(editor, id));
  if (hasMenu) syncNativeMenus(editor);
  autosave(editor);
  keepLayout(editor, localStorage);
  keepRanges(editor, localStorage);
  keepViews(editor, localStorage);
  keepExports(editor, localStorage);
  keepOpenPath(editor, sessionStorage);
  window.addEventListener('beforeunload', (event) => {
    if (hasUnsavedWork(editor)) event.preventDefault();
  });
  root.render(
    <StrictMode>
      <App editor={editor} previewSync={previewSync} previewUrl={previewUrl} />
    </StrictMode>,
  );
  await openFirst(editor, sessionStorage);
}

void main();

/** Shown instead of the editor if the server refuses the address. */
function NoHost({ why }: { readonly why: string }) {
  return (
    <main className="no-host">
      <Logo />
      <h1>Invalid address</h1>
      <p>{why}</p>
    </main>
  );
}
