import type { MenuItemConstructorOptions } from 'electron';
import type { MenuCommand } from '../contract/contract.ts';

/**
 * The window's menu. Commands of the editor go to its page; their keys are only shown here, because the page handles them
 * itself, knowing whether a text field has the focus.
 */
export function menuTemplate(
  platform: NodeJS.Platform,
  packaged: boolean,
  send: (command: MenuCommand) => void,
): MenuItemConstructorOptions[] {
  const item = (label: string, accelerator: string | null, command: MenuCommand): MenuItemConstructorOptions => ({
    label,
    ...(accelerator !== null && { accelerator, registerAccelerator: false }),
    click: () => send(command),
  });
  const separator: MenuItemConstructorOptions = { type: 'separator' };
  return [
    ...(platform === 'darwin' ? [{ role: 'appMenu' } as const] : []),
    {
      label: '&File',
      submenu: [
        item('New Project…', 'CmdOrCtrl+Alt+N', 'file.new'),
        item('Open Project…', 'CmdOrCtrl+O', 'file.open'),
        separator,
        item('Save', 'CmdOrCtrl+S', 'file.save'),
        item('Save As…', 'CmdOrCtrl+Shift+S', 'file.save-as'),
        separator,
        item('Export Page…', 'CmdOrCtrl+E', 'file.export'),
        item('Render Frames…', 'CmdOrCtrl+Shift+E', 'file.render'),
        separator,
        { role: platform === 'darwin' ? 'close' : 'quit' },
      ],
    },
    {
      label: '&Edit',
      submenu: [
        item('Undo', 'CmdOrCtrl+Z', 'edit.undo'),
        item('Redo', 'CmdOrCtrl+Shift+Z', 'edit.redo'),
        separator,
        { role: 'cut' },
        { role: 'copy' },
        { role: 'paste' },
        item('Delete', 'Delete', 'edit.delete'),
        item('Select All', 'CmdOrCtrl+A', 'edit.select-all'),
      ],
    },
    {
      label: '&View',
      submenu: [
        item('Show the Whole Graph', 'F', 'view.fit'),
        item('Find in the Graph…', 'CmdOrCtrl+F', 'view.find'),
        separator,
        { role: 'zoomIn' },
        { role: 'zoomOut' },
        { role: 'resetZoom' },
        separator,
        { role: 'togglefullscreen' },
        ...(packaged ? [] : [separator, { role: 'toggleDevTools' } as const]),
      ],
    },
    { role: 'windowMenu' },
    {
      role: 'help',
      submenu: [
        item('Help for the Node', 'F1', 'view.help'),
        item('All Commands…', 'CmdOrCtrl+K', 'help.commands'),
        item('Keyboard Shortcuts…', '?', 'help.shortcuts'),
        separator,
        item('Take the Tour', null, 'help.tour'),
      ],
    },
  ];
}
