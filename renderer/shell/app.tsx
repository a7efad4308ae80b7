import { useSyncExternalStore } from 'react';
import { useStore } from 'zustand';
import { Canvas } from '../canvas/canvas.tsx';
import { HelpPanel } from '../help/help-panel.tsx';
import { Inspector } from '../inspector/inspector.tsx';
import { PreviewPanel } from '../preview-panel/preview-panel.tsx';
import type { Editor } from '../state/editor/editor.ts';
import { shownShape } from '../state/editor/preview-state.ts';
import type { PanelSizes } from '../state/editor/ui.ts';
import { arrangeSide, type SideArrangement } from '../state/preferences/panel-layout.ts';
import type { PreviewSync } from '../state/preview-sync/preview-sync.ts';
import { Split, type SplitProps } from '../ui/split.tsx';
import { TooltipLayer } from '../ui/tooltip.tsx';
import './app.css';
import { EditorProvider, useEditor } from '../state/editor/editor-context.ts';
import { PreviewSyncProvider } from '../state/preview-sync/preview-sync-context.ts';
import { BottomPanel, useBottomTab } from './bottom-panel.tsx';
import { Dialogs } from './dialogs.tsx';
import { StatusBar } from './status-bar.tsx';
import { Toasts } from './toasts.tsx';
import { TopBar } from './top-bar.tsx';
import { Tour } from './tour-card.tsx';
import { useFileDrops } from './use-file-drops.ts';
import { useShortcuts } from './use-shortcuts.ts';

interface AppProps {
  readonly editor: Editor;
  readonly previewSync: PreviewSync;
  readonly previewUrl: string;
}

export function App({ editor, previewSync, previewUrl }: AppProps) {
  return (
    <EditorProvider value={editor}>
      <PreviewSyncProvider value={previewSync}>
        <Layout previewUrl={previewUrl} />
      </PreviewSyncProvider>
    </EditorProvider>
  );
}

function Layout({ previewUrl }: { readonly previewUrl: string }) {
  const { clock, ui } = useEditor();
  const extent = useStore(ui, (state) => state.previewExtent);
  useShortcuts();
  useFileDrops();
  return (
    <div className="app" data-preview={extent}>
      <TopBar />
      <main className="app-main">
        <Workspace previewUrl={previewUrl} />
      </main>
      <StatusBar />
      <Toasts />
      <Tour />
      <Dialogs />
      <TooltipLayer clock={clock} />
    </div>
  );
}

/** Graph, preview and inspector. A change of their arrangement moves the panes by CSS alone, so that the preview page is not reloaded. */
function Workspace({ previewUrl }: { readonly previewUrl: string }) {
  const dock = useStore(useEditor().ui, (state) => state.dock);
  const { side, graphLeastPx } = useSideArrangement();
  const below = dock === 'below';
  return (
    <Panes
      direction={below ? 'rows' : 'columns'}
      fixed="second"
      reversed={dock === 'left'}
      label={below ? 'Height of preview and inspector' : 'Width of preview and inspector'}
      size={below ? 'belowHeightPx' : side}
      minPx={below ? 200 : 300}
      otherMinPx={below ? 200 : graphLeastPx}
      first={<GraphArea />}
      second={<PreviewAndInspector previewUrl={previewUrl} />}
    />
  );
}

function GraphArea() {
  const tab = useBottomTab();
  return (
    <Panes
      direction="rows"
      fixed="second"
      label="Height of the panel below the graph"
      size="bottomHeightPx"
      minPx={120}
      otherMinPx={160}
      first={<GraphAndHelp />}
      second={tab === null ? null : <BottomPanel tab={tab} />}
    />
  );
}

function GraphAndHelp() {
  const help = useStore(useEditor().ui, (state) => state.help);
  return (
    <Panes
      direction="columns"
      fixed="second"
      label="Width of the help panel"
      size="helpWidthPx"
      minPx={200}
      otherMinPx={320}
      first={<Canvas />}
      second={help ? <HelpPanel /> : null}
    />
  );
}

function PreviewAndInspector({ previewUrl }: { readonly previewUrl: string }) {
  const dock = useStore(useEditor().ui, (state) => state.dock);
  const side = useSideArrangement();
  const panes = { first: <PreviewPanel previewUrl={previewUrl} />, second: <Inspector /> };
  if (dock !== 'below' && side.place === 'above')
    return (
      <Panes {...panes} direction="rows" fixed="first" label="Height of the preview" size={side.preview} minPx={160} otherMinPx={160} />
    );
  return (
    <Panes
      {...panes}
      direction="columns"
      fixed="second"
      // The picture stands beside the graph.
      reversed={dock === 'left'}
      label="Width of the inspector"
      size={dock !== 'below' && side.place === 'beside' ? side.inspector : 'inspectorWidthPx'}
      minPx={260}
      otherMinPx={dock === 'below' ? 300 : 200}
    />
  );
}

function useSideArrangement(): SideArrangement {
  const { preview, ui } = useEditor();
  const shape = useStore(preview, shownShape);
  const sizes = useStore(ui, (state) => state.sizes);
  const windowWidthPx = useSyncExternalStore(onWindowResize, () => window.innerWidth);
  return arrangeSide(shape, sizes, windowWidthPx);
}

function onWindowResize(notify: () => void): () => void {
  window.addEventListener('resize', notify);
  return () => window.removeEventListener('resize', notify);
}

/**
 * Split panes with a persistent size, stored for UI scale 1. A resize does not rerender the content of the panes, because their elements come
 * from the parent.
 */
function Panes({ size, ...panes }: Omit<SplitProps, 'sizePx' | 'onResize'> & { readonly size: keyof PanelSizes }) {
  const { ui, preferences } = useEditor();
  const sizePx = useStore(ui, (state) => state.sizes[size]);
  const scale = useStore(preferences, (state) => state.scale);
  return (
    <Split
      {...panes}
      minPx={panes.minPx * scale}
      sizePx={Math.round(sizePx * scale)}
      onResize={(px) => ui.setState(({ sizes }) => ({ sizes: { ...sizes, [size]: px / scale } }))}
    />
  );
}
