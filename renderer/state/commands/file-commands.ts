import { lastExport, openExportDialog } from '../files/export-page.ts';
import { newProject, openProject, openSaveAs, save } from '../files/files.ts';
import { revertToSaved } from '../files/revert.ts';
import { openRenderDialog } from '../preview/render-frames.ts';
import type { AppCommand } from './app-command.ts';
import { always, hasCapture, hasMesh, isOpen, isUnsaved } from './command-conditions.ts';

/** Commands of the File menu. */
export const FILE_COMMANDS = {
  // Browsers reserve Ctrl+N.
  'file.new': {
    label: 'New…',
    keywords: ['create', 'start', 'template', 'new project'],
    keys: ['Mod+Alt+N'],
    enabled: always,
    run: newProject,
    whileTyping: true,
  },
  'file.open': {
    label: 'Open…',
    keywords: ['load', 'recent', 'example', 'open project'],
    keys: ['Mod+O'],
    enabled: always,
    run: openProject,
    whileTyping: true,
  },
  'file.save': { label: 'Save', keys: ['Mod+S'], enabled: isOpen, run: (editor) => void save(editor), whileTyping: true },
  'file.save-as': {
    label: 'Save as…',
    keywords: ['copy', 'duplicate project', 'rename'],
    keys: ['Mod+Shift+S'],
    enabled: isOpen,
    run: (editor) => openSaveAs(editor),
    whileTyping: true,
  },
  'file.revert': {
    label: 'Revert to saved',
    keywords: ['discard changes', 'undo all', 'last save'],
    keys: [],
    enabled: isUnsaved,
    run: (editor) => void revertToSaved(editor),
  },
  'file.export': {
    label: 'Export page…',
    keywords: ['publish', 'share', 'web page', 'html', 'upload'],
    keys: ['Mod+E'],
    enabled: isOpen,
    run: openExportDialog,
    whileTyping: true,
  },
  'file.exported': {
    label: 'Exported page…',
    keywords: ['qr code', 'size of the page', 'open in browser', 'publish', 'last export'],
    keys: [],
    enabled: (editor) => lastExport(editor) !== null,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'exported' } }),
  },
  'file.render': {
    label: 'Render frames…',
    keywords: ['video', 'movie', 'image sequence', 'png'],
    keys: ['Mod+Shift+E'],
    enabled: isOpen,
    run: openRenderDialog,
    whileTyping: true,
  },
  'file.photograph': {
    label: 'Photograph the scene…',
    keywords: ['capture', 'acquisition', 'lumigraph', 'image-based rendering', '360', 'photos'],
    keys: ['Mod+Alt+P'],
    enabled: isOpen,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'photograph' } }),
    whileTyping: true,
  },
  'file.photographs': {
    label: 'Import photographs…',
    keywords: ['capture', 'colmap', 'photogrammetry', 'reconstruct', 'scan', 'place', 'room'],
    keys: ['Mod+Alt+I'],
    enabled: isOpen,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'photographs', folder: '' } }),
    whileTyping: true,
  },
  'file.simplify': {
    label: 'Simplify a model…',
    keywords: ['reduce', 'decimate', 'triangles', 'polygons', 'Blender', 'Instant Meshes', 'capture', 'mesh', 'low poly'],
    keys: [],
    enabled: hasMesh,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'simplify' } }),
  },
  'file.rephotograph': {
    label: 'Rephotograph a capture…',
    keywords: ['quality', 'measure', 'evaluation', 'PSNR', 'SSIM', 'error map', 'leave one out'],
    keys: [],
    enabled: hasCapture,
    run: ({ ui }) => ui.setState({ dialog: { kind: 'rephotograph' } }),
  },
} as const satisfies Record<string, AppCommand>;
