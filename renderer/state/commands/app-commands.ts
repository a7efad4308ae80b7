import { copySelection, cutSelection, duplicateSelection, pasteFromClipboard } from '../clipboard/clipboard.ts';
import { redo } from '../document/apply.ts';
import { undoOrCancelDrag } from '../document/cancel-drag.ts';
import type { Editor } from '../editor/editor.ts';
import { toggleMode } from '../editor/gizmo-state.ts';
import { frameOf } from '../editor/preview-state.ts';
import { align, distribute, tidy } from '../graph/arrange.ts';
import { deleteSelection, selectAll, toggleCollapsed, toggleMuted, toggleUnfused } from '../graph/edit-graph.ts';
import { addFrame, addNote } from '../graph/layout-items.ts';
import { addRerouteToSelected, soleWire } from '../graph/reroutes.ts';
import { createSubgraph, leaveSubgraph, makeUnique, openSubgraph, selectedSubgraph, ungroupSelected } from '../graph/subgraphs.ts';
import {
  clearRange,
  goToFrame,
  goToStart,
  lastFrame,
  playedRange,
  setIn,
  setOut,
  stepFrames,
  toggleLoop,
  togglePlay,
} from '../preview/playback.ts';
import { canRecordSession, toggleSessionRecording } from '../preview/record-session.ts';
import { canDuplicateFilter, duplicateFilter, newFilter } from '../shaders/new-filter.ts';
import type { AppCommand } from './app-command.ts';
import { askToSaveSubgraph, canvasCenter, openPalette, openSwapPalette } from './command-actions.ts';
import {
  always,
  canRedo,
  canUndo,
  hasFrames,
  hasNodes,
  hasOneNode,
  hasRange,
  hasSelection,
  hasSeveral,
  hasSubgraph,
  isInside,
  isOpen,
} from './command-conditions.ts';
import { FILE_COMMANDS } from './file-commands.ts';
import { PREVIEW_COMMANDS } from './preview-commands.ts';
import { startTour } from './tour.ts';
import { VIEW_COMMANDS } from './view-commands.ts';

const COMMANDS = {
  ...FILE_COMMANDS,
  'edit.undo': { label: 'Undo', keywords: ['back', 'revert'], keys: ['Mod+Z'], enabled: canUndo, run: undoOrCancelDrag },
  'edit.redo': { label: 'Redo', keys: ['Mod+Shift+Z', 'Mod+Y'], enabled: canRedo, run: redo },
  'edit.cut': { label: 'Cut', keys: ['Mod+X'], enabled: hasNodes, run: (editor) => void cutSelection(editor), byEvent: true },
  'edit.copy': { label: 'Copy', keys: ['Mod+C'], enabled: hasNodes, run: (editor) => void copySelection(editor), byEvent: true },
  'edit.paste': { label: 'Paste', keys: ['Mod+V'], enabled: isOpen, run: (editor) => void pasteFromClipboard(editor), byEvent: true },
  'edit.duplicate': {
    label: 'Duplicate',
    keywords: ['copy', 'clone'],
    keys: ['Mod+D'],
    enabled: hasNodes,
    run: (editor) => void duplicateSelection(editor),
  },
  'edit.duplicate-wired': {
    label: 'Duplicate with wires',
    keys: ['Mod+Shift+D'],
    enabled: hasNodes,
    run: (editor) => void duplicateSelection(editor, { wired: true }),
  },
  'edit.delete': {
    label: 'Delete',
    keywords: ['remove', 'erase'],
    keys: ['Delete', 'Backspace'],
    enabled: hasSelection,
    run: (editor) => void deleteSelection(editor),
  },
  'edit.select-all': { label: 'Select all', keys: ['Mod+A'], enabled: isOpen, run: selectAll },
  'edit.mute': {
    label: 'Mute',
    keywords: ['bypass', 'disable'],
    keys: ['M'],
    enabled: hasNodes,
    run: (editor) => void toggleMuted(editor),
  },
  'edit.unfuse': {
    label: 'Do not fuse passes',
    keywords: ['fusion', 'shader', 'pass'],
    keys: [],
    enabled: hasNodes,
    run: (editor) => void toggleUnfused(editor),
  },
  'graph.add': {
    label: 'Add node…',
    keywords: ['filter', 'effect', 'new', 'insert', 'palette'],
    keys: ['Tab', 'Shift+A'],
    enabled: isOpen,
    run: openPalette,
  },
  'graph.new-filter': {
    label: 'New filter',
    keywords: ['shader', 'glsl', 'isf', 'write', 'own', 'custom'],
    keys: [],
    enabled: isOpen,
    run: (editor) => void newFilter(editor),
  },
  'graph.duplicate-filter': {
    label: 'Duplicate filter',
    keywords: ['shader', 'glsl', 'isf', 'new', 'own', 'copy', 'fork', 'edit', 'customize'],
    keys: [],
    enabled: canDuplicateFilter,
    run: (editor) => void duplicateFilter(editor),
  },
  'graph.import-shadertoy': {
    label: 'Import Shadertoy…',
    keys: [],
    enabled: isOpen,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'shadertoy' } }),
  },
  'graph.swap': { label: 'Change type…', keywords: ['swap', 'replace'], keys: ['Shift+S'], enabled: hasOneNode, run: openSwapPalette },
  'graph.reroute': {
    label: 'Add reroute',
    keys: ['R'],
    enabled: ({ selection }) => soleWire(selection.getState()) !== null,
    run: (editor) => void addRerouteToSelected(editor),
  },
  'graph.collapse': {
    label: 'Collapse',
    keywords: ['minimize', 'fold'],
    keys: ['H'],
    enabled: hasNodes,
    run: (editor) => void toggleCollapsed(editor),
  },
  'graph.subgraph': {
    label: 'Create subgraph',
    keywords: ['make', 'group'],
    keys: ['Mod+G'],
    enabled: hasNodes,
    run: (editor) => void createSubgraph(editor),
  },
  'graph.unpack': {
    label: 'Ungroup subgraph',
    keywords: ['unpack', 'expand'],
    keys: ['Mod+Shift+G'],
    enabled: hasSubgraph,
    run: (editor) => void ungroupSelected(editor),
  },
  'graph.independent': {
    label: 'Make subgraph unique',
    keywords: ['independent', 'single user'],
    keys: [],
    enabled: hasSubgraph,
    run: (editor) => void makeUnique(editor),
  },
  'graph.save': { label: 'Save to the library…', keywords: ['subgraph'], keys: [], enabled: hasSubgraph, run: askToSaveSubgraph },
  'graph.save-recipe': {
    label: 'Save as recipe…',
    keywords: ['preset', 'template', 'reuse', 'own', 'snippet'],
    keys: [],
    enabled: hasNodes,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'recipe' } }),
  },
  'graph.recipes': {
    label: 'My recipes…',
    keywords: ['manage', 'delete', 'rename', 'preset'],
    keys: [],
    enabled: always,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'recipes' } }),
  },
  'graph.enter': {
    label: 'Open subgraph',
    keywords: ['enter', 'edit'],
    keys: ['I'],
    enabled: hasSubgraph,
    run: (editor) => openSubgraph(editor, selectedSubgraph(editor) ?? ''),
  },
  'graph.leave': { label: 'Leave subgraph', keywords: ['exit', 'back'], keys: ['U'], enabled: isInside, run: leaveSubgraph },
  'graph.frame': {
    label: 'Add frame',
    keywords: ['group box'],
    keys: ['C'],
    enabled: isOpen,
    run: (editor) => void addFrame(editor, canvasCenter(editor)),
  },
  'graph.note': {
    label: 'Add note',
    keywords: ['comment'],
    keys: ['N'],
    enabled: isOpen,
    run: (editor) => void addNote(editor, canvasCenter(editor)),
  },
  'arrange.tidy': {
    label: 'Tidy up',
    keywords: ['clean up', 'auto layout', 'arrange'],
    keys: ['L'],
    enabled: isOpen,
    run: (editor) => void tidy(editor),
  },
  'arrange.left': { label: 'Align left', keys: [], enabled: hasSeveral, run: (editor) => void align(editor, 'left') },
  'arrange.centre': { label: 'Align centers', keys: [], enabled: hasSeveral, run: (editor) => void align(editor, 'center') },
  'arrange.right': { label: 'Align right', keys: [], enabled: hasSeveral, run: (editor) => void align(editor, 'right') },
  'arrange.top': { label: 'Align top', keys: [], enabled: hasSeveral, run: (editor) => void align(editor, 'top') },
  'arrange.middle': { label: 'Align middles', keys: [], enabled: hasSeveral, run: (editor) => void align(editor, 'middle') },
  'arrange.bottom': { label: 'Align bottom', keys: [], enabled: hasSeveral, run: (editor) => void align(editor, 'bottom') },
  'arrange.across': { label: 'Distribute horizontally', keys: [], enabled: hasSeveral, run: (editor) => void distribute(editor, 'x') },
  'arrange.down': { label: 'Distribute vertically', keys: [], enabled: hasSeveral, run: (editor) => void distribute(editor, 'y') },
  ...VIEW_COMMANDS,
  ...PREVIEW_COMMANDS,
  // The keys of other 3D programs. G is a second key, because W walks in emulated rooms.
  'gizmo.move': {
    label: 'Move gizmo',
    keywords: ['translate', 'position'],
    keys: ['W', 'G'],
    enabled: isOpen,
    run: ({ gizmo }) => toggleMode(gizmo, 'move'),
  },
  'gizmo.rotate': {
    label: 'Rotate gizmo',
    keywords: ['turn', 'rotation'],
    keys: ['E'],
    enabled: isOpen,
    run: ({ gizmo }) => toggleMode(gizmo, 'rotate'),
  },
  'gizmo.scale': {
    label: 'Scale gizmo',
    keywords: ['resize', 'size'],
    keys: ['S'],
    enabled: isOpen,
    run: ({ gizmo }) => toggleMode(gizmo, 'scale'),
  },
  'gizmo.space': {
    label: 'Local or world space',
    keywords: ['axes', 'orientation'],
    keys: ['X'],
    enabled: isOpen,
    run: ({ gizmo }) => gizmo.setState(({ space }) => ({ space: space === 'world' ? 'local' : 'world' })),
  },
  'gizmo.snap': {
    label: 'Snap gizmo',
    keywords: ['grid', 'increments'],
    keys: ['Shift+X'],
    enabled: isOpen,
    run: ({ gizmo }) => gizmo.setState(({ snap }) => ({ snap: !snap })),
  },
  'play.toggle': { label: 'Play or pause', keys: ['Space'], enabled: isOpen, run: togglePlay, where: 'time' },
  'play.next': {
    label: 'Next frame',
    keywords: ['step', 'one frame on'],
    keys: ['ArrowRight'],
    enabled: isOpen,
    run: (editor) => stepFrames(editor, 1),
    where: 'time',
  },
  'play.back': {
    label: 'Previous frame',
    keywords: ['step', 'back'],
    keys: ['ArrowLeft'],
    enabled: hasFrames,
    run: (editor) => stepFrames(editor, -1),
    where: 'time',
  },
  'play.first': { label: 'Go to first frame', keywords: ['start'], keys: ['Home'], enabled: isOpen, run: goToStart, where: 'time' },
  'play.last': {
    label: 'Go to last frame',
    keywords: ['end'],
    keys: ['End'],
    enabled: hasFrames,
    run: (editor) => goToFrame(editor, lastFrame(editor.preview.getState())),
    where: 'time',
  },
  'play.in': {
    label: 'Set in point',
    keywords: ['begin', 'range'],
    keys: ['I'],
    enabled: hasFrames,
    run: (editor) => setIn(editor, frameOf(editor.preview.getState())),
    where: 'time',
  },
  'play.out': {
    label: 'Set out point',
    keywords: ['end', 'range'],
    keys: ['O'],
    enabled: hasFrames,
    run: (editor) => setOut(editor, frameOf(editor.preview.getState())),
    where: 'time',
  },
  'play.to-in': {
    label: 'Go to in point',
    keywords: ['start', 'range'],
    keys: ['Shift+I'],
    enabled: hasFrames,
    run: (editor) => goToFrame(editor, playedRange(editor.preview.getState()).from),
    where: 'time',
  },
  'play.to-out': {
    label: 'Go to out point',
    keywords: ['end', 'range'],
    keys: ['Shift+O'],
    enabled: hasFrames,
    run: (editor) => goToFrame(editor, playedRange(editor.preview.getState()).to),
    where: 'time',
  },
  'play.whole': {
    label: 'Clear play range',
    keywords: ['play all', 'whole recording'],
    keys: ['X'],
    enabled: hasRange,
    run: clearRange,
    where: 'time',
  },
  'play.loop': { label: 'Loop', keywords: ['repeat'], keys: ['Shift+L'], enabled: hasFrames, run: toggleLoop, where: 'time' },
  'play.record': {
    label: 'Record session',
    keywords: ['input', 'pointers', 'hands', 'capture', 'stop recording', 'macro'],
    keys: [],
    enabled: canRecordSession,
    run: toggleSessionRecording,
  },
  'help.commands': {
    label: 'All commands…',
    // The second key is that of text editors.
    keys: ['Mod+K', 'Mod+Shift+P'],
    enabled: always,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'commands' } }),
    whileTyping: true,
  },
  'help.tour': { label: 'Take the tour', keywords: ['tutorial', 'introduction', 'learn'], keys: [], enabled: isOpen, run: startTour },
  'help.shortcuts': {
    label: 'Keyboard shortcuts',
    keywords: ['hotkeys', 'keys', 'keybindings'],
    keys: ['?'],
    enabled: always,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'shortcuts' } }),
  },
} as const satisfies Record<string, AppCommand>;

export type AppCommandId = keyof typeof COMMANDS;

export function appCommand(id: AppCommandId): AppCommand {
  return COMMANDS[id];
}

export function appCommandIds(): readonly AppCommandId[] {
  return Object.keys(COMMANDS) as AppCommandId[];
}

/** Runs a command if it is enabled. */
export function runCommand(editor: Editor, id: AppCommandId): void {
  const { enabled, run } = appCommand(id);
  if (enabled(editor)) run(editor);
}
