import { useStore } from 'zustand';
import { CodePanel } from '../code/code-panel.tsx';
import type { BottomTab } from '../state/editor/ui.ts';
import { TimelinePanel } from '../timeline/timeline-panel.tsx';
import { IconButton } from '../ui/button.tsx';
import './bottom-panel.css';
import { useEditor } from '../state/editor/editor-context.ts';
import { ProblemsPanel } from './problems-panel.tsx';

const TABS: readonly { readonly id: BottomTab; readonly label: string }[] = [
  { id: 'code', label: 'Shader' },
  { id: 'timeline', label: 'Timeline' },
  { id: 'problems', label: 'Problems' },
];

/** Tabs below the graph: shader source, timeline and problems. */
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
      <div className="bottom-body">{tab === 'code' ? <CodePanel /> : tab === 'timeline' ? <TimelinePanel /> : <ProblemsPanel />}</div>
    </section>
  );
}

/** The open tab; null if the panel is closed. */
export function useBottomTab(): BottomTab | null {
  return useStore(useEditor().ui, (state) => state.bottom);
}
