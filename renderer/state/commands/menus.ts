import type { PlatformMenu } from '../../../app/contract/contract.ts';
import type { Editor } from '../editor/editor.ts';
import { type AppCommandId, appCommand } from './app-commands.ts';
import { tickOf } from './command-ticks.ts';
import { keybindingsOf } from './keybindings.ts';

/** The menu bar. A native menu bar has the same menus. */
export const MENUS: readonly { readonly label: string; readonly entries: readonly (AppCommandId | 'line')[] }[] = [
  {
    label: 'File',
    entries: [
      'file.new',
      'file.open',
      'line',
      'file.save',
      'file.save-as',
      'file.revert',
      'line',
      'graph.import-shadertoy',
      'file.export',
      'file.exported',
      'file.render',
      'file.photograph',
      'file.photographs',
      'file.rephotograph',
      'file.simplify',
    ],
  },
  {
    label: 'Edit',
    entries: [
      'edit.undo',
      'edit.redo',
      'line',
      'edit.cut',
      'edit.copy',
      'edit.paste',
      'edit.duplicate',
      'edit.duplicate-wired',
      'edit.delete',
      'line',
      'edit.select-all',
      'edit.mute',
      'edit.unfuse',
    ],
  },
  {
    label: 'Graph',
    entries: [
      'graph.add',
      'graph.new-filter',
      'graph.duplicate-filter',
      'graph.swap',
      'graph.collapse',
      'graph.frame',
      'graph.note',
      'graph.reroute',
      'line',
      'graph.subgraph',
      'graph.save',
      'graph.save-recipe',
      'graph.recipes',
      'graph.enter',
      'graph.leave',
      'graph.independent',
      'graph.unpack',
    ],
  },
  {
    label: 'Arrange',
    entries: [
      'arrange.tidy',
      'line',
      'arrange.left',
      'arrange.centre',
      'arrange.right',
      'line',
      'arrange.top',
      'arrange.middle',
      'arrange.bottom',
      'line',
      'arrange.across',
      'arrange.down',
    ],
  },
  {
    label: 'View',
    entries: [
      'view.find',
      'view.fit',
      'view.fit-selection',
      'line',
      'view.thumbnails',
      'view.costs',
      'line',
      'view.code',
      'view.timeline',
      'view.assets',
      'view.history',
      'view.problems',
      'line',
      'view.larger',
      'view.smaller',
      'view.usual-size',
      'line',
      'view.theme',
      'view.motion',
      'view.wheel',
    ],
  },
  {
    label: 'Preview',
    entries: [
      'view.pin',
      'view.compare',
      'view.screen',
      'view.camera',
      'view.saved',
      'view.probe',
      'line',
      'gizmo.move',
      'gizmo.rotate',
      'gizmo.scale',
      'gizmo.space',
      'gizmo.snap',
      'line',
      'preview.fill',
      'preview.phone',
      'preview.phone-wide',
      'preview.headset',
      'preview.glasses',
      'preview.safe-areas',
      'line',
      'view.preview-full',
      'view.preview-overlay',
      'view.preview-panel',
      'view.pop-out',
      'view.dock-right',
      'view.dock-left',
      'view.dock-below',
      'line',
      'preview.keep-image',
      'preview.poster',
      'preview.render-size',
    ],
  },
  {
    label: 'Playback',
    entries: [
      'play.toggle',
      'play.next',
      'play.back',
      'play.first',
      'play.last',
      'line',
      'play.in',
      'play.out',
      'play.to-in',
      'play.to-out',
      'play.whole',
      'play.loop',
      'line',
      'play.record',
    ],
  },
  { label: 'Help', entries: ['view.help', 'help.commands', 'help.shortcuts', 'line', 'help.tour'] },
];

/** The current state of the menus for the native menu bar. While a dialog is open, all commands are disabled. */
export function platformMenus(editor: Editor): PlatformMenu[] {
  const { dialog, palette } = editor.ui.getState();
  const free = dialog === null && palette === null;
  return MENUS.map(({ label, entries }) => ({
    label,
    entries: entries.map((id) => {
      if (id === 'line') return id;
      const command = appCommand(id);
      return {
        command: id,
        label: command.label,
        keybinding: keybindingsOf(editor, id)[0] ?? null,
        enabled: free && command.enabled(editor),
        checked: tickOf(editor, id)?.on ?? null,
      };
    }),
  }));
}

/** Pause before an update of the native menus, because playback changes the state with every frame. */
const REST_MS = 60;

/**
 * Keeps the native menus in sync with the editor.
 *
 * @returns A function that stops it.
 */
export function syncNativeMenus(editor: Editor): () => void {
  let shown = '';
  let waiting: (() => void) | null = null;
  const show = () => {
    waiting = null;
    const menus = platformMenus(editor);
    const text = JSON.stringify(menus);
    if (text === shown) return;
    shown = text;
    editor.host.call('menu.show', { menus }).catch(() => {
      // The native menus are outdated; the next change tries again.
      shown = '';
    });
  };
  const soon = () => {
    waiting ??= editor.clock.after(REST_MS, show);
  };
  const { document, selection, preview, viewer, ui, preferences, costs, gizmo } = editor;
  const stops = [document, selection, preview, viewer, ui, preferences, costs, gizmo].map((store) => store.subscribe(soon));
  show();
  return () => {
    waiting?.();
    for (const stop of stops) stop();
  };
}
