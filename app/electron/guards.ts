import type { App, Session } from 'electron';
import { ORIGINS } from './scheme.ts';

/** What the editor may ask the browser for: to copy text, and to fill the screen. */
const ALLOWED_PERMISSIONS: ReadonlySet<string> = new Set(['clipboard-sanitized-write', 'fullscreen']);

/** Pages stay where they are: no navigation but a reload of the editor, no new windows, no guests. */
export function guardContents(app: App): void {
  app.on('web-contents-created', (_event, contents) => {
    contents.setWindowOpenHandler(() => ({ action: 'deny' }));
    contents.on('will-navigate', (event, url) => {
      if (!isEditor(url)) event.preventDefault();
    });
    contents.on('will-redirect', (event) => event.preventDefault());
    contents.on('will-attach-webview', (event) => event.preventDefault());
  });
}

/** No device, no sensor, no address but our own; the preview may listen, where a project does, and see, where the user chose the webcam. */
export function guardSession(session: Session): void {
  session.setPermissionRequestHandler((_contents, permission, callback, details) =>
    callback(
      permission === 'media' ? isPreview(details.requestingUrl) : ALLOWED_PERMISSIONS.has(permission) && isEditor(details.requestingUrl),
    ),
  );
  session.setPermissionCheckHandler((_contents, permission, origin) =>
    permission === 'media' ? isPreview(origin) : ALLOWED_PERMISSIONS.has(permission) && isEditor(origin),
  );
  session.setDevicePermissionHandler(() => false);
  const elsewhere = ['http://*/*', 'https://*/*', 'ws://*/*', 'wss://*/*', 'ftp://*/*', 'file://*/*'];
  session.webRequest.onBeforeRequest({ urls: elsewhere }, (_details, callback) => callback({ cancel: true }));
}

/** An origin comes without a slash at its end. */
function isEditor(url: string): boolean {
  return url === ORIGINS.editor || url.startsWith(`${ORIGINS.editor}/`);
}

function isPreview(url: string): boolean {
  return url === ORIGINS.preview || url.startsWith(`${ORIGINS.preview}/`);
}
