import { Panel, useReactFlow, useStore } from '@xyflow/react';
import { useKeys } from '../state/commands/command-item.ts';
import { uiScale } from '../ui/appearance.ts';
import { IconButton } from '../ui/button.tsx';
import { FIT_PADDING } from './use-reveal.ts';

/** Buttons that change the zoom, show its percentage and fit the graph to the view. */
export function CanvasControls() {
  const { zoomIn, zoomOut, zoomTo, fitView } = useReactFlow();
  const zoom = useStore((state) => Math.round(state.transform[2] * 100));
  const fitKeys = useKeys('view.fit');
  return (
    <Panel position="bottom-left" className="canvas-controls">
      <button type="button" className="zoom-step" aria-label="Zoom out" onClick={() => void zoomOut()}>
        −
      </button>
      <button type="button" className="zoom-figure" data-tip="Reset to 100 %" aria-label={`Zoom, ${zoom} %`} onClick={() => void zoomTo(1)}>
        {zoom}%
      </button>
      <button type="button" className="zoom-step" aria-label="Zoom in" onClick={() => void zoomIn()}>
        +
      </button>
      <IconButton
        icon="fit"
        label="Fit graph to view"
        keys={fitKeys}
        onPress={() => void fitView({ padding: FIT_PADDING, maxZoom: uiScale() })}
      />
    </Panel>
  );
}
