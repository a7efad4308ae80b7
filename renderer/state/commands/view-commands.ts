import { editableShader } from '../document/edit-shader.ts';
import { endCandidate } from '../editor/candidate-state.ts';
import { revealNodes } from '../editor/ui.ts';
import { resetViewer } from '../editor/viewer.ts';
import { popOutPreview } from '../preview/pop-out.ts';
import { toggleSavedVersion } from '../preview/saved-version.ts';
import { hideCamera, toggleCamera } from '../preview/untouched-camera.ts';
import { compareSelected, pinSelected } from '../preview/viewed-layers.ts';
import type { AppCommand } from './app-command.ts';
import {
  dockPreview,
  nextScale,
  setScale,
  switchMotion,
  switchTheme,
  switchWheel,
  toggleBottom,
  togglePreviewExtent,
} from './command-actions.ts';
import { always, hasNodes, hasOneNode, isOpen, isUnsaved } from './command-conditions.ts';

/** Commands of the View menu, and those of the Preview menu that concern layers and panels. */
export const VIEW_COMMANDS = {
  'view.find': {
    label: 'Find in the graph…',
    keywords: ['search'],
    keys: ['Mod+F'],
    enabled: isOpen,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'find' } }),
  },
  'view.fit': {
    label: 'Fit graph to view',
    keywords: ['zoom', 'frame all', 'show all', 'whole graph'],
    keys: ['F'],
    enabled: isOpen,
    run: ({ ui }) => revealNodes(ui, [], 'fit'),
  },
  'view.fit-selection': {
    label: 'Show the selection',
    keywords: ['zoom', 'frame selected', 'show'],
    keys: ['Shift+F'],
    enabled: hasNodes,
    run: ({ ui, selection }) => revealNodes(ui, [...selection.getState().nodes], 'fit'),
  },
  'view.thumbnails': {
    label: 'Thumbnails',
    keywords: ['pictures', 'images', 'settings', 'preferences'],
    keys: ['T'],
    enabled: isOpen,
    run: ({ preferences }) => preferences.setState(({ thumbnails }) => ({ thumbnails: !thumbnails })),
  },
  'view.pin': { label: 'Show in the preview', keywords: ['viewer', 'show', 'pin'], keys: ['P'], enabled: hasOneNode, run: pinSelected },
  'view.compare': {
    label: 'Compare in the preview',
    keywords: ['wipe', 'split'],
    keys: ['Shift+P'],
    enabled: hasOneNode,
    run: compareSelected,
  },
  'view.screen': {
    label: 'Show output',
    keywords: ['screen', 'reset viewer'],
    keys: [],
    enabled: ({ viewer }) => viewer.getState().left !== null,
    run: ({ viewer }) => resetViewer(viewer),
  },
  'view.camera': {
    label: 'Untouched camera',
    keywords: ['before', 'original', 'compare', 'without effects', 'hold'],
    keys: ['B'],
    enabled: isOpen,
    run: toggleCamera,
    release: hideCamera,
  },
  'view.saved': {
    label: 'Saved version',
    keywords: ['before', 'last save', 'compare', 'hold'],
    keys: ['Shift+B'],
    enabled: isUnsaved,
    run: toggleSavedVersion,
    release: endCandidate,
  },
  'view.probe': {
    label: 'Pixel probe',
    keywords: ['color', 'depth', 'distance', 'inspect'],
    keys: ['Q'],
    enabled: isOpen,
    run: ({ viewer }) => viewer.setState(({ probing }) => ({ probing: !probing, probed: null })),
  },
  'view.costs': {
    label: 'Performance overlay',
    keywords: ['costs', 'passes', 'memory'],
    keys: ['K'],
    enabled: isOpen,
    run: ({ costs }) => costs.setState(({ on }) => ({ on: !on, measured: [], memory: [] })),
  },
  'view.code': {
    label: 'Shader source',
    keys: ['Mod+J'],
    enabled: (editor) => editableShader(editor) !== null || editor.ui.getState().bottom === 'code',
    run: (editor) => toggleBottom(editor, 'code'),
    whileTyping: true,
  },
  'view.timeline': {
    label: 'Timeline',
    keywords: ['keyframes', 'animation', 'tracks'],
    keys: ['Shift+T'],
    enabled: isOpen,
    run: (editor) => toggleBottom(editor, 'timeline'),
  },
  'view.assets': {
    label: 'Assets',
    keywords: ['files', 'images', 'models', 'replace', 'missing', 'relink', 'unused', 'media'],
    keys: ['Shift+R'],
    enabled: isOpen,
    run: (editor) => toggleBottom(editor, 'assets'),
  },
  'view.history': {
    label: 'History',
    keywords: ['undo list', 'steps', 'versions', 'back in time'],
    keys: ['Shift+U'],
    enabled: isOpen,
    run: (editor) => toggleBottom(editor, 'history'),
  },
  'view.problems': {
    label: 'Problems',
    keywords: ['errors', 'warnings', 'diagnostics'],
    keys: ['Mod+M'],
    enabled: always,
    run: (editor) => toggleBottom(editor, 'problems'),
    whileTyping: true,
  },
  'view.help': {
    label: 'Node help',
    keywords: ['documentation'],
    keys: ['F1'],
    enabled: always,
    run: ({ ui }) => ui.setState(({ help }) => ({ help: !help })),
    whileTyping: true,
  },
  'view.preview-full': {
    label: 'Full-screen preview',
    keywords: ['maximize', 'fullscreen', 'enlarge', 'presentation'],
    keys: ['V'],
    enabled: isOpen,
    run: (editor) => togglePreviewExtent(editor, 'full'),
  },
  'view.preview-panel': {
    label: 'Leave full screen',
    keys: ['Escape'],
    enabled: ({ ui }) => ui.getState().previewExtent !== 'panel',
    run: ({ ui }) => ui.setState({ previewExtent: 'panel' }),
  },
  'view.pop-out': {
    label: 'Pop out preview',
    keywords: ['pop-out', 'second screen', 'monitor', 'detach', 'window'],
    keys: [],
    enabled: isOpen,
    run: (editor) => popOutPreview(editor, !editor.preview.getState().poppedOut),
  },
  'view.preview-overlay': {
    label: 'Graph over preview',
    keywords: ['overlay', 'full screen', 'background'],
    keys: ['Shift+V'],
    enabled: isOpen,
    run: (editor) => togglePreviewExtent(editor, 'overlay'),
  },
  'view.dock-right': {
    label: 'Dock preview right',
    keywords: ['layout', 'panel', 'move', 'side'],
    keys: [],
    enabled: always,
    run: (editor) => dockPreview(editor, 'right'),
  },
  'view.dock-left': {
    label: 'Dock preview left',
    keywords: ['layout', 'panel', 'move', 'side'],
    keys: [],
    enabled: always,
    run: (editor) => dockPreview(editor, 'left'),
  },
  'view.dock-below': {
    label: 'Dock preview below',
    keywords: ['layout', 'panel', 'bottom'],
    keys: [],
    enabled: always,
    run: (editor) => dockPreview(editor, 'below'),
  },
  'view.theme': {
    label: 'Theme',
    keywords: ['light', 'dark', 'night', 'color', 'appearance', 'settings', 'preferences'],
    keys: [],
    enabled: always,
    run: switchTheme,
  },
  // No keys, because Ctrl with plus zooms the browser or the window.
  'view.larger': {
    label: 'Increase UI scale',
    keywords: ['zoom', 'larger', 'text size'],
    keys: [],
    enabled: (editor) => nextScale(editor, 1) !== undefined,
    run: (editor) => setScale(editor, nextScale(editor, 1)),
  },
  'view.smaller': {
    label: 'Decrease UI scale',
    keywords: ['zoom', 'smaller', 'text size'],
    keys: [],
    enabled: (editor) => nextScale(editor, -1) !== undefined,
    run: (editor) => setScale(editor, nextScale(editor, -1)),
  },
  'view.usual-size': {
    label: 'Reset UI scale',
    keywords: ['zoom', 'size', 'usual'],
    keys: [],
    enabled: ({ preferences }) => preferences.getState().scale !== 1,
    run: (editor) => setScale(editor, 1),
  },
  'view.motion': {
    label: 'Reduce motion',
    keywords: ['less motion', 'animation', 'settings', 'preferences'],
    keys: [],
    enabled: always,
    run: switchMotion,
  },
  'view.wheel': {
    label: 'Wheel and trackpad',
    keywords: ['mouse', 'scroll', 'zoom', 'pan', 'two fingers', 'settings', 'preferences'],
    keys: [],
    enabled: always,
    run: switchWheel,
  },
} as const satisfies Record<string, AppCommand>;
