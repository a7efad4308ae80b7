import type { MenuItemConstructorOptions } from 'electron';
import type { PlatformMenu, PlatformMenuEntry } from '../contract/contract.ts';
import { acceleratorOf } from './accelerator.ts';

export interface MenuOptions {
  readonly platform: NodeJS.Platform;
  readonly packaged: boolean;
  readonly send: (command: string) => void;
}

/** What the system does by itself: into text fields as well, and to the editor as the page's own copy and paste events. */
const ROLES: Readonly<Record<string, MenuItemConstructorOptions['role']>> = {
  'edit.cut': 'cut',
  'edit.copy': 'copy',
  'edit.paste': 'paste',
};

const SEPARATOR: MenuItemConstructorOptions = { type: 'separator' };

/**
 * The window's menu: the editor's own, with what windows have beside. Commands go to its page. Their keys are only shown here: the
 * page handles them itself, knowing what has the focus, and nothing is done twice. macOS takes keys of menus in any case, after the
 * page; so there, keys without Cmd, which type text, are not shown.
 */
export function menuTemplate(menus: readonly PlatformMenu[], { platform, packaged, send }: MenuOptions): MenuItemConstructorOptions[] {
  const itemOf = (entry: PlatformMenuEntry): MenuItemConstructorOptions => {
    if (entry === 'line') return SEPARATOR;
    const { command, label, keybinding, enabled } = entry;
    const role = ROLES[command];
    if (role) return { role, label };
    const accelerator = keybinding === null ? null : acceleratorOf(keybinding, platform);
    return {
      id: command,
      label,
      enabled,
      ...(accelerator !== null && { accelerator, registerAccelerator: false }),
      click: () => send(command),
    };
  };
  const more: Readonly<Record<string, readonly MenuItemConstructorOptions[]>> = {
    File: [{ role: platform === 'darwin' ? 'close' : 'quit' }],
    View: [
      { role: 'zoomIn' },
      { role: 'zoomOut' },
      { role: 'resetZoom' },
      SEPARATOR,
      { role: 'togglefullscreen' },
      ...(packaged ? [] : [SEPARATOR, { role: 'toggleDevTools' } as const]),
    ],
  };
  const shown = menus.length > 0 ? menus : [{ label: 'File', entries: [] }];
  return [
    ...(platform === 'darwin' ? [{ role: 'appMenu' } as const] : []),
    ...shown.flatMap(({ label, entries }): MenuItemConstructorOptions[] => {
      const items = [...entries.map(itemOf), ...(entries.length > 0 && more[label] ? [SEPARATOR] : []), ...(more[label] ?? [])];
      return label === 'Help' ? [{ role: 'windowMenu' }, { role: 'help', submenu: items }] : [{ label: `&${label}`, submenu: items }];
    }),
  ];
}

/** What a menu is built from; what can be done now is left out, which a built menu takes without being built anew. */
export function shapeOfMenus(menus: readonly PlatformMenu[]): string {
  return JSON.stringify(menus, (key, value) => (key === 'enabled' ? undefined : value));
}
