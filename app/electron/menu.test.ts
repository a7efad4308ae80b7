import { expect, test } from '@jest/globals';
import type { MenuItemConstructorOptions } from 'electron';
import type { PlatformMenu } from '../contract/contract.ts';
import { menuTemplate, shapeOfMenus } from './menu.ts';

const SAVE = { command: 'file.save', label: 'Save', keybinding: 'Mod+S', enabled: true };
const MENUS: readonly PlatformMenu[] = [
  { label: 'File', entries: [SAVE] },
  {
    label: 'Edit',
    entries: [
      { command: 'edit.undo', label: 'Undo', keybinding: 'Mod+Z', enabled: false },
      'line',
      { command: 'edit.copy', label: 'Copy', keybinding: 'Mod+C', enabled: false },
    ],
  },
  {
    label: 'View',
    entries: [
      { command: 'view.fit', label: 'Fit graph to view', keybinding: 'F', enabled: true },
      { command: 'view.help', label: 'Node help', keybinding: 'F1', enabled: true },
      { command: 'view.odd', label: 'Odd', keybinding: 'Mod+Ä', enabled: true },
    ],
  },
  { label: 'Help', entries: [{ command: 'help.tour', label: 'Take the tour', keybinding: null, enabled: true }] },
];

function built(platform: NodeJS.Platform, menus = MENUS) {
  const sent: string[] = [];
  const template = menuTemplate(menus, { platform, packaged: true, send: (command) => sent.push(command) });
  const items = template.flatMap(({ submenu }) => (Array.isArray(submenu) ? (submenu as MenuItemConstructorOptions[]) : []));
  const item = (id: string) => items.find((candidate) => candidate.id === id);
  return { names: template.map(({ label, role }) => label ?? role), items, item, sent };
}

test('every platform has the menus that its programs have, and the editor’s between them', () => {
  expect(built('linux').names).toEqual(['&File', '&Edit', '&View', 'windowMenu', 'help']);
  expect(built('darwin').names).toEqual(['appMenu', '&File', '&Edit', '&View', 'windowMenu', 'help']);
});

test('before the editor is there, it can be ended all the same', () => {
  expect(built('linux', []).items).toEqual([{ role: 'quit' }]);
});

test('an item asks for its command, and shows whether it can be chosen and its keys, which it does not take itself', () => {
  const { item, sent } = built('linux');
  (item('file.save')?.click as (() => void) | undefined)?.();
  expect(sent).toEqual(['file.save']);
  expect(item('file.save')).toMatchObject({ label: 'Save', enabled: true, accelerator: 'CmdOrCtrl+S', registerAccelerator: false });
  expect(item('edit.undo')).toMatchObject({ enabled: false });
  expect(item('view.fit')).toMatchObject({ accelerator: 'F', registerAccelerator: false });
});

test('copying is left to the system, so that text fields have it too', () => {
  expect(built('linux').items).toContainEqual({ role: 'copy', label: 'Copy' });
});

test('keys that Electron has no name for are left out, and on a Mac those that type text', () => {
  expect(built('linux').item('view.odd')).not.toHaveProperty('accelerator');
  expect(built('darwin').item('view.fit')).not.toHaveProperty('accelerator');
  expect(built('darwin').item('view.help')).toMatchObject({ accelerator: 'F1' });
});

test('a menu is built anew for other keys, not for what can be done now', () => {
  const shape = shapeOfMenus([{ label: 'File', entries: [SAVE] }]);
  expect(shapeOfMenus([{ label: 'File', entries: [{ ...SAVE, enabled: false }] }])).toBe(shape);
  expect(shapeOfMenus([{ label: 'File', entries: [{ ...SAVE, keybinding: 'Mod+Alt+S' }] }])).not.toBe(shape);
});
