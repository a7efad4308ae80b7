import { useStore } from 'zustand';
import { Canvas } from '../canvas/canvas.tsx';
import { HelpPanel } from '../help/help-panel.tsx';
import { Inspector } from '../inspector/inspector.tsx';
import { PreviewPanel } from '../preview-panel/preview-panel.tsx';
import type { Editor } from '../state/editor/editor.ts';
import type { PanelSizes } from '../state/editor/ui.ts';
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
  const { clock } = useEditor();
  useShortcuts();
  return (
    <div className="app">
      <TopBar />
      <main className="app-main">
        <Panes
          direction="columns"
          fixed="second"
          label="Width of preview and inspector"
          size="sideWidthPx"
          minPx={300}
          otherMinPx={360}
          first={<GraphArea />}
          second={<SideColumn previewUrl={previewUrl} />}
        />
      </main>
      <StatusBar />
      <Toasts />
      <Tour />
      <Dialogs />
      <TooltipLayer clock={clock} />
    </div>
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

function SideColumn({ previewUrl }: { readonly previewUrl: string }) {
  return (
    <Panes
      direction="rows"
      fixed="first"
      label="Height of the preview"
      size="previewHeightPx"
      minPx={160}
      otherMinPx={160}
      first={<PreviewPanel previewUrl={previewUrl} />}
      second={<Inspector />}
    />
  );
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
