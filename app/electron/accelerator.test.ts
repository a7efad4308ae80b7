import { expect, test } from '@jest/globals';
import { acceleratorOf } from './accelerator.ts';

test.each([
  ['Mod+Shift+Z', 'CmdOrCtrl+Shift+Z'],
  ['Mod+Ctrl+Alt+X', 'CmdOrCtrl+Ctrl+Alt+X'],
  ['ArrowRight', 'Right'],
  ['Shift+Home', 'Shift+Home'],
  ['Space', 'Space'],
  ['?', '?'],
  ['F12', 'F12'],
  ['+', 'Plus'],
  ['Mod++', 'CmdOrCtrl+Plus'],
  ['Mod+-', 'CmdOrCtrl+-'],
  ['Dead', null],
  ['F25', null],
])('%s is %s', (keybinding, accelerator) => {
  expect(acceleratorOf(keybinding, 'linux')).toBe(accelerator);
});
