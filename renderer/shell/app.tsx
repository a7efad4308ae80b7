import { useStore } from 'zustand';
import { Canvas } from '../canvas/canvas.tsx';
import { HelpPanel } from '../help/help-panel.tsx';
import { Inspector } from '../inspector/inspector.tsx';
import { Stage } from '../stage/stage.tsx';
import type { Editor } from '../state/editor.ts';
import type { Feed } from '../state/feed.ts';
import type { PanelSizes } from '../state/ui.ts';
import { Split } from '../ui/split.tsx';
import { TooltipLayer } from '../ui/tooltip.tsx';
import './app.css';
import { BottomPanel, useBottomTab } from './bottom-panel.tsx';
import { Dialogs } from './dialogs.tsx';
import { EditorProvider, useEditor } from './editor-context.ts';
import { FeedProvider } from './feed-context.ts';
import { StatusBar } from './status-bar.tsx';
import { Toasts } from './toasts.tsx';
import { TopBar } from './top-bar.tsx';
import { Tour } from './tour-card.tsx';
import { useShortcuts } from './use-shortcuts.ts';

interface AppProps {
  readonly editor: Editor;
  readonly feed: Feed;
  readonly previewUrl: string;
}

export function App({ editor, feed, previewUrl }: AppProps) {
  return (
    <EditorProvider value={editor}>
      <FeedProvider value={feed}>
        <Frame previewUrl={previewUrl} />
      </FeedProvider>
    </EditorProvider>
  );
}

function Frame({ previewUrl }: { readonly previewUrl: string }) {
  const { ui, clock } = useEditor();
  const { sideWidthPx } = useStore(ui, (state) => state.sizes);
  useShortcuts();
  return (
    <div className="app">
      <TopBar />
      <main className="app-main">
        <Split
          direction="columns"
          fixed="second"
          label="Width of preview and inspector"
          sizePx={sideWidthPx}
          minPx={300}
          otherMinPx={360}
          onResize={(px) => resize(ui, { sideWidthPx: px })}
          first={<Work />}
          second={<Side previewUrl={previewUrl} />}
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

function Work() {
  const { ui } = useEditor();
  const tab = useBottomTab();
  const { bottomHeightPx } = useStore(ui, (state) => state.sizes);
  return (
    <Split
      direction="rows"
      fixed="second"
      label="Height of the panel below the graph"
      sizePx={bottomHeightPx}
      minPx={120}
      otherMinPx={160}
      onResize={(px) => resize(ui, { bottomHeightPx: px })}
      first={<Graph />}
      second={tab === null ? null : <BottomPanel tab={tab} />}
    />
  );
}

function Graph() {
  const { ui } = useEditor();
  const help = useStore(ui, (state) => state.help);
  const { helpWidthPx } = useStore(ui, (state) => state.sizes);
  return (
    <Split
      direction="columns"
      fixed="second"
      label="Width of the help"
      sizePx={helpWidthPx}
      minPx={200}
      otherMinPx={320}
      onResize={(px) => resize(ui, { helpWidthPx: px })}
      first={<Canvas />}
      second={help ? <HelpPanel /> : null}
    />
  );
}

function Side({ previewUrl }: { readonly previewUrl: string }) {
  const { ui } = useEditor();
  const { previewHeightPx } = useStore(ui, (state) => state.sizes);
  return (
    <Split
      direction="rows"
      fixed="first"
      label="Height of the preview"
      sizePx={previewHeightPx}
      minPx={160}
      otherMinPx={160}
      onResize={(px) => resize(ui, { previewHeightPx: px })}
      first={<Stage previewUrl={previewUrl} />}
      second={<Inspector />}
    />
  );
}

function resize(ui: Editor['ui'], size: Partial<PanelSizes>): void {
  ui.setState(({ sizes }) => ({ sizes: { ...sizes, ...size } }));
}
