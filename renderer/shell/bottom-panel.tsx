import { useStore } from 'zustand';
import { CodePanel } from '../code/code-panel.tsx';
import type { BottomTab } from '../state/editor/ui.ts';
import { TimelinePanel } from '../timeline/timeline-panel.tsx';
import { IconButton } from '../ui/button.tsx';
import './bottom-panel.css';
import { useEditor } from '../state/editor/editor-context.ts';
import { AssetsPanel } from './assets-panel.tsx';
import { HistoryPanel } from './history-panel.tsx';
import { ProblemsPanel } from './problems-panel.tsx';

const TABS: readonly { readonly id: BottomTab; readonly label: string }[] = [
  { id: 'code', label: 'Shader' },
  { id: 'timeline', label: 'Timeline' },
  { id: 'assets', label: 'Assets' },
  { id: 'history', label: 'History' },
  { id: 'problems', label: 'Problems' },
];

/** Tabs below the graph: shader source, timeline, assets, history and problems. */
export function BottomPanel({ tab }: { readonly tab: BottomTab }) {
  const { ui } = useEditor();
  return (
    <section className="bottom-panel" aria-label={TABS.find(({ id }) => id === tab)?.label}>
      <div className="bottom-tabs">
        {TABS.map(({ id, label }) => (
          <button key={id} type="button" className="bottom-tab" aria-pressed={id === tab} onClick={() => ui.setState({ bottom: id })}>
            {label}
          </button>
        ))}
        <span className="bottom-gap" />
        <IconButton icon="close" label="Close the panel" small onPress={() => ui.setState({ bottom: null })} />
      </div>
      <div className="bottom-body">
        <Body tab={tab} />
      </div>
    </section>
  );
}

function Body({ tab }: { readonly tab: BottomTab }) {
  switch (tab) {
    case 'code':
      return <CodePanel />;
    case 'timeline':
      return <TimelinePanel />;
    case 'assets':
      return <AssetsPanel />;
    case 'history':
      return <HistoryPanel />;
    case 'problems':
      return <ProblemsPanel />;
  }
}

/** The open tab; null if the panel is closed. */
export function useBottomTab(): BottomTab | null {
  return useStore(useEditor().ui, (state) => state.bottom);
}
