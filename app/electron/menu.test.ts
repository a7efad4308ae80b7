import { expect, test } from '@jest/globals';
import { MENU_COMMANDS, type MenuCommand } from '../contract/contract.ts';
import { menuTemplate } from './menu.ts';

/** Menus by label or role, and what each item of the editor's sends. */
function built(platform: NodeJS.Platform) {
  const sent: MenuCommand[] = [];
  const menus = menuTemplate(platform, true, (command) => sent.push(command));
  for (const { submenu } of menus) {
    if (!Array.isArray(submenu)) continue;
    // Electron gives the item, the window and the event, which none of these looks at.
    for (const { click } of submenu) (click as (() => void) | undefined)?.();
  }
  return { names: menus.map(({ label, role }) => label ?? role), sent };
}

test('every platform has the menus that its programs have', () => {
  const common = ['&File', '&Edit', '&View', 'windowMenu', 'help'];
  expect(built('linux').names).toEqual(common);
  expect(built('win32').names).toEqual(common);
  expect(built('darwin').names).toEqual(['appMenu', ...common]);
});

test('each command of the contract stands in one of them, once', () => {
  expect(built('linux').sent.sort()).toEqual([...MENU_COMMANDS].sort());
});
