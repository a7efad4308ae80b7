import type { App, Session, WindowOpenHandlerResponse } from 'electron';
import { ORIGINS } from './scheme.ts';

/** Permissions of the editor: to write text to the clipboard, and full screen. */
const ALLOWED_PERMISSIONS: ReadonlySet<string> = new Set(['clipboard-sanitized-write', 'fullscreen']);

/** An empty window that the editor fills with the preview. It has no preload script, so it cannot call the host. */
const PREVIEW_WINDOW: WindowOpenHandlerResponse = {
  action: 'allow',
  overrideBrowserWindowOptions: { title: 'Preview', autoHideMenuBar: true, backgroundColor: '#0b0c0e' },
};

/** Prevents navigation other than a reload of the editor, webviews, and new windows other than that of the preview. */
export function guardContents(app: App): void {
  app.on('web-contents-created', (_event, contents) => {
    contents.setWindowOpenHandler(({ url }) =>
      url === 'about:blank' && isEditor(contents.getURL()) ? PREVIEW_WINDOW : { action: 'deny' },
    );
    contents.on('will-navigate', (event, url) => {
      if (!isEditor(url)) event.preventDefault();
    });
    contents.on('will-redirect', (event) => event.preventDefault());
    contents.on('will-attach-webview', (event) => event.preventDefault());
  });
}

/**
 * Limits the permissions of pages: the preview may use the camera and microphone, the editor has `ALLOWED_PERMISSIONS`, all others are
 * denied, such as devices and sensors. Also cancels requests to other origins.
 */
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

/** Whether the URL is on the origin of the editor. Origins have no trailing slash. */
function isEditor(url: string): boolean {
  return url === ORIGINS.editor || url.startsWith(`${ORIGINS.editor}/`);
}

function isPreview(url: string): boolean {
  return url === ORIGINS.preview || url.startsWith(`${ORIGINS.preview}/`);
}
