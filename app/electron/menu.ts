import type { MenuItemConstructorOptions } from 'electron';
import type { PlatformMenu, PlatformMenuEntry } from '../contract/contract.ts';
import { acceleratorOf } from './accelerator.ts';

export interface MenuOptions {
  readonly platform: NodeJS.Platform;
  readonly packaged: boolean;
  readonly send: (command: string) => void;
}

/** Commands that have a role in Electron. Roles also work in text fields, and trigger the copy and paste events of the page. */
const ROLES: Readonly<Record<string, MenuItemConstructorOptions['role']>> = {
  'edit.cut': 'cut',
  'edit.copy': 'copy',
  'edit.paste': 'paste',
};

const SEPARATOR: MenuItemConstructorOptions = { type: 'separator' };

/**
 * Template of the native menu: the menus of the editor and the usual items of the system. Commands are sent to the page. Their keys
 * are only displayed, because the page handles them depending on the focus. macOS always triggers the keys of menu items, so keys
 * without Cmd, which type text, are left out there.
 */
export function menuTemplate(menus: readonly PlatformMenu[], { platform, packaged, send }: MenuOptions): MenuItemConstructorOptions[] {
  const itemOf = (entry: PlatformMenuEntry): MenuItemConstructorOptions => {
    if (entry === 'line') return SEPARATOR;
    const { command, label, keybinding, enabled, checked } = entry;
    const role = ROLES[command];
    if (role) return { role, label };
    const accelerator = keybinding === null ? null : acceleratorOf(keybinding, platform);
    return {
      id: command,
      label,
      enabled,
      ...(checked !== null && { type: 'checkbox' as const, checked }),
      ...(accelerator !== null && { accelerator, registerAccelerator: false }),
      click: (item) => {
        // Electron has switched the tick; the editor says what is on.
        if (checked !== null) item.checked = !item.checked;
        send(command);
      },
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

/** The structure of the menus without their enabled states and ticks, which can change without a rebuild. */
export function shapeOfMenus(menus: readonly PlatformMenu[]): string {
  return JSON.stringify(menus, (key, value) => (key === 'enabled' || (key === 'checked' && value !== null) ? undefined : value));
}
