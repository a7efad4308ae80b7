import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import { shownFrame } from '../state/editor/preview-state.ts';
import './safe-areas.css';

/** The parts of a phone's screen that its camera, its rounded corners and its home indicator cover or cut, where a page must not put text. */
export function SafeAreas() {
  const { preview } = useEditor();
  const frame = useStore(preview, shownFrame);
  const wanted = useStore(preview, (state) => state.safeAreas);
  if (!wanted || (frame !== 'phone' && frame !== 'phone-wide')) return null;
  return (
    <div className="safe-areas" data-frame={frame} aria-hidden="true">
      <span className="safe-areas-camera" />
      <span className="safe-areas-home" />
    </div>
  );
}
