import { useStore } from 'zustand';
import { Canvas } from '../canvas/canvas.tsx';
import { HelpPanel } from '../help/help-panel.tsx';
import { Inspector } from '../inspector/inspector.tsx';
import { Stage } from '../stage/stage.tsx';
import type { Editor } from '../state/editor.ts';
import type { Feed } from '../state/feed.ts';
import type { PanelSizes } from '../state/ui.ts';
import { Split, type SplitProps } from '../ui/split.tsx';
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
  const tab = useBottomTab();
  return (
    <Panes
      direction="rows"
      fixed="second"
      label="Height of the panel below the graph"
      size="bottomHeightPx"
      minPx={120}
      otherMinPx={160}
      first={<Graph />}
      second={tab === null ? null : <BottomPanel tab={tab} />}
    />
  );
}

function Graph() {
  const help = useStore(useEditor().ui, (state) => state.help);
  return (
    <Panes
      direction="columns"
      fixed="second"
      label="Width of the help"
      size="helpWidthPx"
      minPx={200}
      otherMinPx={320}
      first={<Canvas />}
      second={help ? <HelpPanel /> : null}
    />
  );
}

function Side({ previewUrl }: { readonly previewUrl: string }) {
  return (
    <Panes
      direction="rows"
      fixed="first"
      label="Height of the preview"
      size="previewHeightPx"
      minPx={160}
      otherMinPx={160}
      first={<Stage previewUrl={previewUrl} />}
      second={<Inspector />}
    />
  );
}

/** Two panes whose handle moves a size that is kept, as it is where text and controls are as they are made. What is in them is not drawn anew by it: whoever made them is not. */
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
