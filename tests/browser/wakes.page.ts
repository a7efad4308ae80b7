import { createElement, Profiler, type ReactNode } from 'react';
import { createRoot } from 'react-dom/client';
import { Canvas } from '../../renderer/canvas/canvas.tsx';
import { pageClock } from '../../renderer/clock.ts';
import { HelpPanel } from '../../renderer/help/help-panel.tsx';
import { Inspector } from '../../renderer/inspector/inspector.tsx';
import { StatusBar } from '../../renderer/shell/status-bar.tsx';
import { TopBar } from '../../renderer/shell/top-bar.tsx';
import type { Editor } from '../../renderer/state/editor/editor.ts';
import { EditorProvider } from '../../renderer/state/editor/editor-context.ts';
import { selectOnly } from '../../renderer/state/editor/selection.ts';
import { addNodeFromPalette, connect } from '../../renderer/state/graph/edit-graph.ts';
import type { PreviewSync } from '../../renderer/state/preview-sync/preview-sync.ts';
import { PreviewSyncProvider } from '../../renderer/state/preview-sync/preview-sync-context.ts';
import { openTestEditor } from '../support/test-editor.ts';

const drawn: Record<string, number> = {};

/** Counts how often React draws anything of it. */
function counted(name: string, child: ReactNode): ReactNode {
  drawn[name] = 0;
  const onRender = () => {
    drawn[name] = (drawn[name] ?? 0) + 1;
  };
  return createElement(Profiler, { id: name, onRender }, child);
}

const PREVIEW_SYNC: PreviewSync = { attach: () => () => {}, receive: () => {}, send: () => {}, dispose: () => {} };

let editor: Editor | null = null;

/** The editor's parts, one below the other, over a blur of the video, which is selected; answers with its node. */
export async function open(): Promise<string> {
  const opened = await openTestEditor();
  const here: Editor = { ...opened.editor, clock: pageClock };
  editor = here;
  const add = (type: string, x: number) => {
    const definition = here.document.getState().library.definition(type);
    const id = definition && addNodeFromPalette(here, { definition, port: null }, { x, y: 0 }, null);
    if (!id) throw new Error(`${type} was not added.`);
    return id;
  };
  const video = add('source/camera-video', 0);
  const blur = add('filter/gaussian-blur', 260);
  connect(here, { node: video, port: 'layer' }, { node: blur, port: 'inputImage' });
  selectOnly(here.selection, [blur]);
  const parts = [
    counted('top bar', createElement(TopBar)),
    counted('canvas', createElement('div', { style: { width: 900, height: 500 } }, createElement(Canvas))),
    counted('inspector', createElement(Inspector)),
    counted('help', createElement(HelpPanel)),
    counted('status bar', createElement(StatusBar)),
  ];
  const element = document.createElement('div');
  document.body.append(element);
  createRoot(element).render(
    createElement(EditorProvider, { value: here }, createElement(PreviewSyncProvider, { value: PREVIEW_SYNC }, ...parts)),
  );
  return blur;
}

export function forget(): void {
  for (const name of Object.keys(drawn)) drawn[name] = 0;
}

export function counts(): Readonly<Record<string, number>> {
  return drawn;
}

/** What undo would take back. */
export function lastStep(): string | undefined {
  return editor?.document.getState().history.past.at(-1)?.label;
}
