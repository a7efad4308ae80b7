import { redo, undo } from './apply.ts';
import { align, distribute, tidy } from './arrange.ts';
import type { Place } from './canvas.ts';
import { copySelection, cutSelection, duplicateSelection, pasteFromClipboard } from './clipboard.ts';
import { deleteSelection, selectAll, toggleCollapsed, toggleMuted } from './edit-graph.ts';
import { editableShader } from './edit-shader.ts';
import type { Editor } from './editor.ts';
import { exportPage } from './export-page.ts';
import { newProject, openProject, save, saveAs } from './files.ts';
import { toggleMode } from './gizmo-state.ts';
import { idsOfKind } from './item-ids.ts';
import { addFrame, addNote } from './layout-items.ts';
import { compareSelected, lookAtNothing, pinSelected } from './looks.ts';
import { clearRange, goToFrame, goToStart, lastFrame, playedRange, setIn, setOut, stepFrames, toggleLoop, togglePlay } from './playing.ts';
import { SCALES } from './preferences.ts';
import { frameOf } from './preview.ts';
import { askForFrames } from './render-frames.ts';
import { addRerouteToSelected, soleWire } from './reroutes.ts';
import { soleNode } from './selection.ts';
import { leaveSubgraph, makeIndependent, makeSubgraph, openSubgraph, selectedSubgraph, unpackSelected } from './subgraphs.ts';
import { startTour } from './tour.ts';
import { addToast, type BottomTab, middleOfWindow, revealNodes } from './ui.ts';

/** Something that a menu, a key or the window's own menu can ask for. */
export interface AppCommand {
  readonly label: string;
  /** As `chordOf` writes them, where the person has no others (`chordsOf`). */
  readonly chords: readonly string[];
  readonly enabled: (editor: Editor) => boolean;
  readonly run: (editor: Editor) => void;
  /** The page's own copy and paste events do it: they need no permission. */
  readonly byEvent?: true;
  /** Also while a text field has the focus. */
  readonly whileTyping?: true;
  /** A key of the timeline and the preview, while the focus is there. */
  readonly where?: 'time';
}

const always = () => true;
const isOpen = ({ document }: Editor) => document.getState().open !== null;
const hasNodes = ({ selection }: Editor) => selection.getState().nodes.size > 0;
const hasSelection = ({ selection }: Editor) => Object.values(selection.getState()).some((set: ReadonlySet<string>) => set.size > 0);

const hasFrames = ({ preview }: Editor) => preview.getState().frames !== null;
const hasRange = ({ preview }: Editor) => preview.getState().frames !== null && preview.getState().range !== null;
const hasSeveral = ({ selection }: Editor) => {
  const { nodes, items } = selection.getState();
  return nodes.size + idsOfKind(items, 'reroute').length > 1;
};
const hasOneNode = ({ selection }: Editor) => soleNode(selection.getState()) !== null;
const hasSubgraph = (editor: Editor) => selectedSubgraph(editor) !== null;
const isInside = ({ document }: Editor) => document.getState().trail.length > 0;

const COMMANDS = {
  // Browsers keep Ctrl+N for themselves; with Alt it is free everywhere.
  'file.new': { label: 'New…', chords: ['Mod+Alt+N'], enabled: always, run: newProject, whileTyping: true },
  'file.open': { label: 'Open…', chords: ['Mod+O'], enabled: always, run: openProject, whileTyping: true },
  'file.save': { label: 'Save', chords: ['Mod+S'], enabled: isOpen, run: (editor) => void save(editor), whileTyping: true },
  'file.save-as': { label: 'Save as…', chords: ['Mod+Shift+S'], enabled: isOpen, run: (editor) => void saveAs(editor), whileTyping: true },
  'file.export': { label: 'Export page…', chords: ['Mod+E'], enabled: isOpen, run: (editor) => void exportPage(editor), whileTyping: true },
  'file.render': { label: 'Render frames…', chords: ['Mod+Shift+E'], enabled: isOpen, run: askForFrames, whileTyping: true },
  'edit.undo': { label: 'Undo', chords: ['Mod+Z'], enabled: ({ document }) => document.getState().history.past.length > 0, run: undo },
  'edit.redo': {
    label: 'Redo',
    chords: ['Mod+Shift+Z', 'Mod+Y'],
    enabled: ({ document }) => document.getState().history.future.length > 0,
    run: redo,
  },
  'edit.cut': { label: 'Cut', chords: ['Mod+X'], enabled: hasNodes, run: (editor) => void cutSelection(editor), byEvent: true },
  'edit.copy': { label: 'Copy', chords: ['Mod+C'], enabled: hasNodes, run: (editor) => void copySelection(editor), byEvent: true },
  'edit.paste': { label: 'Paste', chords: ['Mod+V'], enabled: isOpen, run: (editor) => void pasteFromClipboard(editor), byEvent: true },
  'edit.duplicate': { label: 'Duplicate', chords: ['Mod+D'], enabled: hasNodes, run: (editor) => void duplicateSelection(editor) },
  'edit.duplicate-wired': {
    label: 'Duplicate with wires',
    chords: ['Mod+Shift+D'],
    enabled: hasNodes,
    run: (editor) => void duplicateSelection(editor, { wired: true }),
  },
  'edit.delete': { label: 'Delete', chords: ['Delete', 'Backspace'], enabled: hasSelection, run: (editor) => void deleteSelection(editor) },
  'edit.select-all': { label: 'Select all', chords: ['Mod+A'], enabled: isOpen, run: selectAll },
  'edit.mute': { label: 'Mute', chords: ['M'], enabled: hasNodes, run: (editor) => void toggleMuted(editor) },
  'graph.add': { label: 'Add node…', chords: ['Tab', 'Shift+A'], enabled: isOpen, run: openPalette },
  'graph.import-shadertoy': {
    label: 'Import Shadertoy…',
    chords: [],
    enabled: isOpen,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'shadertoy' } }),
  },
  'graph.swap': { label: 'Change type…', chords: ['Shift+S'], enabled: hasOneNode, run: openSwapPalette },
  'graph.reroute': {
    label: 'Add a reroute',
    chords: ['R'],
    enabled: ({ selection }) => soleWire(selection.getState()) !== null,
    run: (editor) => void addRerouteToSelected(editor),
  },
  'graph.collapse': { label: 'Collapse', chords: ['H'], enabled: hasNodes, run: (editor) => void toggleCollapsed(editor) },
  'graph.subgraph': { label: 'Make a subgraph', chords: ['Mod+G'], enabled: hasNodes, run: (editor) => void makeSubgraph(editor) },
  'graph.unpack': {
    label: 'Unpack the subgraph',
    chords: ['Mod+Shift+G'],
    enabled: hasSubgraph,
    run: (editor) => void unpackSelected(editor),
  },
  'graph.independent': {
    label: 'Make the subgraph independent',
    chords: [],
    enabled: hasSubgraph,
    run: (editor) => void makeIndependent(editor),
  },
  'graph.save': { label: 'Save to the library…', chords: [], enabled: hasSubgraph, run: askToSaveSubgraph },
  'graph.enter': {
    label: 'Open the subgraph',
    chords: ['I'],
    enabled: hasSubgraph,
    run: (editor) => openSubgraph(editor, selectedSubgraph(editor) ?? ''),
  },
  'graph.leave': { label: 'Leave the subgraph', chords: ['U'], enabled: isInside, run: leaveSubgraph },
  'graph.frame': { label: 'Add a frame', chords: ['C'], enabled: isOpen, run: (editor) => void addFrame(editor, middleOfCanvas(editor)) },
  'graph.note': { label: 'Add a note', chords: ['N'], enabled: isOpen, run: (editor) => void addNote(editor, middleOfCanvas(editor)) },
  'arrange.tidy': { label: 'Tidy up', chords: ['L'], enabled: isOpen, run: (editor) => void tidy(editor) },
  'arrange.left': { label: 'Align left', chords: [], enabled: hasSeveral, run: (editor) => void align(editor, 'left') },
  'arrange.centre': { label: 'Align centres', chords: [], enabled: hasSeveral, run: (editor) => void align(editor, 'centre') },
  'arrange.right': { label: 'Align right', chords: [], enabled: hasSeveral, run: (editor) => void align(editor, 'right') },
  'arrange.top': { label: 'Align top', chords: [], enabled: hasSeveral, run: (editor) => void align(editor, 'top') },
  'arrange.middle': { label: 'Align middles', chords: [], enabled: hasSeveral, run: (editor) => void align(editor, 'middle') },
  'arrange.bottom': { label: 'Align bottom', chords: [], enabled: hasSeveral, run: (editor) => void align(editor, 'bottom') },
  'arrange.across': { label: 'Distribute across', chords: [], enabled: hasSeveral, run: (editor) => void distribute(editor, 'x') },
  'arrange.down': { label: 'Distribute down', chords: [], enabled: hasSeveral, run: (editor) => void distribute(editor, 'y') },
  'view.find': {
    label: 'Find in the graph…',
    chords: ['Mod+F'],
    enabled: isOpen,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'find' } }),
  },
  'view.fit': { label: 'Show the whole graph', chords: ['F'], enabled: isOpen, run: ({ ui }) => revealNodes(ui, [], 'fit') },
  'view.fit-selection': {
    label: 'Show the selection',
    chords: ['Shift+F'],
    enabled: hasNodes,
    run: ({ ui, selection }) => revealNodes(ui, [...selection.getState().nodes], 'fit'),
  },
  'view.thumbnails': {
    label: 'Pictures on nodes',
    chords: ['T'],
    enabled: isOpen,
    run: ({ look }) => look.setState(({ thumbnails }) => ({ thumbnails: !thumbnails })),
  },
  'view.pin': { label: 'Show in the preview', chords: ['P'], enabled: hasOneNode, run: pinSelected },
  'view.compare': { label: 'Compare in the preview', chords: ['Shift+P'], enabled: hasOneNode, run: compareSelected },
  'view.screen': {
    label: 'Show the screen again',
    chords: [],
    enabled: ({ look }) => look.getState().left !== null,
    run: ({ look }) => lookAtNothing(look),
  },
  'view.probe': {
    label: 'Pixel probe',
    chords: ['Q'],
    enabled: isOpen,
    run: ({ look }) => look.setState(({ probing }) => ({ probing: !probing, probed: null })),
  },
  // As 3D programs have them; G as well, because W walks in rooms.
  'gizmo.move': { label: 'Move in the preview', chords: ['W', 'G'], enabled: isOpen, run: ({ gizmo }) => toggleMode(gizmo, 'move') },
  'gizmo.rotate': { label: 'Turn in the preview', chords: ['E'], enabled: isOpen, run: ({ gizmo }) => toggleMode(gizmo, 'rotate') },
  'gizmo.scale': { label: 'Resize in the preview', chords: ['S'], enabled: isOpen, run: ({ gizmo }) => toggleMode(gizmo, 'scale') },
  'gizmo.space': {
    label: 'Axes of the object or of the world',
    chords: ['X'],
    enabled: isOpen,
    run: ({ gizmo }) => gizmo.setState(({ space }) => ({ space: space === 'world' ? 'local' : 'world' })),
  },
  'gizmo.snap': {
    label: 'Snap in the preview',
    chords: ['Shift+X'],
    enabled: isOpen,
    run: ({ gizmo }) => gizmo.setState(({ snap }) => ({ snap: !snap })),
  },
  'view.costs': {
    label: 'Costs on nodes',
    chords: ['K'],
    enabled: isOpen,
    run: ({ costs }) => costs.setState(({ on }) => ({ on: !on, measured: [] })),
  },
  'view.code': {
    label: 'Shader source',
    chords: ['Mod+J'],
    enabled: (editor) => editableShader(editor) !== null || editor.ui.getState().bottom === 'code',
    run: (editor) => toggleBottom(editor, 'code'),
    whileTyping: true,
  },
  'view.timeline': { label: 'Timeline', chords: ['Shift+T'], enabled: isOpen, run: (editor) => toggleBottom(editor, 'timeline') },
  'view.problems': {
    label: 'Problems',
    chords: ['Mod+M'],
    enabled: always,
    run: (editor) => toggleBottom(editor, 'problems'),
    whileTyping: true,
  },
  'view.help': {
    label: 'Help for the node',
    chords: ['F1'],
    enabled: always,
    run: ({ ui }) => ui.setState(({ help }) => ({ help: !help })),
    whileTyping: true,
  },
  'view.theme': { label: 'Light or dark', chords: [], enabled: always, run: switchTheme },
  // Without keys: Ctrl and plus are the browser's and the window's own, which make everything larger.
  'view.larger': {
    label: 'Larger text and controls',
    chords: [],
    enabled: (editor) => nextScale(editor, 1) !== undefined,
    run: (editor) => setScale(editor, nextScale(editor, 1)),
  },
  'view.smaller': {
    label: 'Smaller text and controls',
    chords: [],
    enabled: (editor) => nextScale(editor, -1) !== undefined,
    run: (editor) => setScale(editor, nextScale(editor, -1)),
  },
  'view.usual-size': {
    label: 'Text and controls as large as usual',
    chords: [],
    enabled: ({ preferences }) => preferences.getState().scale !== 1,
    run: (editor) => setScale(editor, 1),
  },
  'view.motion': { label: 'Less motion', chords: [], enabled: always, run: switchMotion },
  'play.toggle': { label: 'Play or pause', chords: ['Space'], enabled: isOpen, run: togglePlay, where: 'time' },
  'play.next': { label: 'One frame on', chords: ['ArrowRight'], enabled: isOpen, run: (editor) => stepFrames(editor, 1), where: 'time' },
  'play.back': {
    label: 'One frame back',
    chords: ['ArrowLeft'],
    enabled: hasFrames,
    run: (editor) => stepFrames(editor, -1),
    where: 'time',
  },
  'play.first': { label: 'To the first frame', chords: ['Home'], enabled: isOpen, run: goToStart, where: 'time' },
  'play.last': {
    label: 'To the last frame',
    chords: ['End'],
    enabled: hasFrames,
    run: (editor) => goToFrame(editor, lastFrame(editor.preview.getState())),
    where: 'time',
  },
  'play.in': {
    label: 'Begin the range here',
    chords: ['I'],
    enabled: hasFrames,
    run: (editor) => setIn(editor, frameOf(editor.preview.getState())),
    where: 'time',
  },
  'play.out': {
    label: 'End the range here',
    chords: ['O'],
    enabled: hasFrames,
    run: (editor) => setOut(editor, frameOf(editor.preview.getState())),
    where: 'time',
  },
  'play.to-in': {
    label: 'To the start of the range',
    chords: ['Shift+I'],
    enabled: hasFrames,
    run: (editor) => goToFrame(editor, playedRange(editor.preview.getState()).from),
    where: 'time',
  },
  'play.to-out': {
    label: 'To the end of the range',
    chords: ['Shift+O'],
    enabled: hasFrames,
    run: (editor) => goToFrame(editor, playedRange(editor.preview.getState()).to),
    where: 'time',
  },
  'play.whole': { label: 'Play all of the recording', chords: ['X'], enabled: hasRange, run: clearRange, where: 'time' },
  'play.loop': { label: 'Loop', chords: ['Shift+L'], enabled: hasFrames, run: toggleLoop, where: 'time' },
  'help.commands': {
    label: 'All commands…',
    // The second as in text editors.
    chords: ['Mod+K', 'Mod+Shift+P'],
    enabled: always,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'commands' } }),
    whileTyping: true,
  },
  'help.tour': { label: 'Take the tour', chords: [], enabled: isOpen, run: startTour },
  'help.shortcuts': {
    label: 'Keyboard shortcuts',
    chords: ['?'],
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

/** Does nothing where the command is not enabled. */
export function runCommand(editor: Editor, id: AppCommandId): void {
  const { enabled, run } = appCommand(id);
  if (enabled(editor)) run(editor);
}

function openSwapPalette({ ui, selection }: Editor): void {
  const node = soleNode(selection.getState());
  if (node !== null) ui.setState({ palette: { at: middleOfWindow(), place: null, end: null, swap: node } });
}

function askToSaveSubgraph(editor: Editor): void {
  const name = selectedSubgraph(editor);
  if (name !== null) editor.ui.setState({ dialog: { kind: 'library', name } });
}

/** Canvas units: the middle of what is seen. */
function middleOfCanvas({ canvas }: Editor): Place {
  return canvas.getState().middle();
}

/** With one wire selected and nothing else, the new node goes into it. */
function openPalette({ ui, selection }: Editor): void {
  const { nodes, wires } = selection.getState();
  const [wire] = nodes.size === 0 && wires.size === 1 ? wires : [];
  ui.setState({ palette: { at: middleOfWindow(), place: null, end: null, ...(wire === undefined ? {} : { wire }) } });
}

/** From what the system says to the other, and from there to and fro. */
function switchTheme({ preferences, ui }: Editor): void {
  const next = { system: 'light', light: 'dark', dark: 'system' } as const;
  const theme = next[preferences.getState().theme];
  preferences.setState({ theme });
  addToast(ui, { tone: 'info', text: theme === 'system' ? 'Light or dark, as the system has it.' : `The ${theme} theme.` });
}

function nextScale({ preferences }: Editor, by: 1 | -1): number | undefined {
  const scales: readonly number[] = SCALES;
  return scales[scales.indexOf(preferences.getState().scale) + by];
}

function setScale({ preferences, ui }: Editor, scale = 1): void {
  preferences.setState({ scale });
  addToast(ui, { tone: 'info', text: `Text and controls at ${Math.round(scale * 100)} %.` });
}

function switchMotion({ preferences, ui }: Editor): void {
  const motion = preferences.getState().motion === 'reduced' ? 'system' : 'reduced';
  preferences.setState({ motion });
  addToast(ui, { tone: 'info', text: motion === 'reduced' ? 'Nothing moves by itself.' : 'Motion as the system has it.' });
}

function toggleBottom({ ui }: Editor, tab: BottomTab): void {
  ui.setState(({ bottom }) => ({ bottom: bottom === tab ? null : tab }));
}
