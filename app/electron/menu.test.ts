import { expect, test } from '@jest/globals';
import type { MenuItemConstructorOptions } from 'electron';
import type { PlatformMenu } from '../contract/contract.ts';
import { menuTemplate, shapeOfMenus } from './menu.ts';

const SAVE = { command: 'file.save', label: 'Save', keybinding: 'Mod+S', enabled: true, checked: null };
const MENUS: readonly PlatformMenu[] = [
  { label: 'File', entries: [SAVE] },
  {
    label: 'Edit',
    entries: [
      { command: 'edit.undo', label: 'Undo', keybinding: 'Mod+Z', enabled: false, checked: null },
      'line',
      { command: 'edit.copy', label: 'Copy', keybinding: 'Mod+C', enabled: false, checked: null },
    ],
  },
  {
    label: 'View',
    entries: [
      { command: 'view.fit', label: 'Fit graph to view', keybinding: 'F', enabled: true, checked: null },
      { command: 'view.help', label: 'Node help', keybinding: 'F1', enabled: true, checked: null },
      { command: 'view.odd', label: 'Odd', keybinding: 'Mod+Ä', enabled: true, checked: null },
    ],
  },
  { label: 'Help', entries: [{ command: 'help.tour', label: 'Take the tour', keybinding: null, enabled: true, checked: null }] },
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

test('what a command switches has a tick, which only the editor sets', () => {
  const help = { command: 'view.help', label: 'Node help', keybinding: 'F1', enabled: true, checked: true };
  const { item, sent } = built('linux', [{ label: 'View', entries: [help, SAVE] }]);
  expect(item('view.help')).toMatchObject({ type: 'checkbox', checked: true });
  expect(item('file.save')).not.toHaveProperty('checked');
  // As Electron calls it: the tick is already gone.
  const clicked = { checked: false };
  const click = item('view.help')?.click as ((item: { checked: boolean }) => void) | undefined;
  click?.(clicked);
  expect([clicked.checked, sent]).toEqual([true, ['view.help']]);
});

test('a menu is built anew for other keys, not for what can be done now', () => {
  const shape = shapeOfMenus([{ label: 'File', entries: [SAVE] }]);
  expect(shapeOfMenus([{ label: 'File', entries: [{ ...SAVE, enabled: false }] }])).toBe(shape);
  expect(shapeOfMenus([{ label: 'File', entries: [{ ...SAVE, keybinding: 'Mod+Alt+S' }] }])).not.toBe(shape);
  const ticked = (checked: boolean) => shapeOfMenus([{ label: 'File', entries: [{ ...SAVE, checked }] }]);
  expect(ticked(true)).toBe(ticked(false));
});
