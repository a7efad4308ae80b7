import { type KeyboardEvent, type PointerEvent, useCallback, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { POSTER_SIZE } from '../../app/contract/poster-size.ts';
import { cropAt, cropOf, type ViewCrop } from '../../nodes/kit/poster-framing.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { chosenSource } from '../state/editor/preview-state.ts';
import { keepFraming } from '../state/files/poster.ts';
import { Button, IconButton } from '../ui/button.tsx';
import './poster-guide.css';

const SHAPE = POSTER_SIZE.widthPx / POSTER_SIZE.heightPx;
const KEY_STEP = 0.01;
/** Factor of a key or a button. */
const ZOOM_STEP = 1.1;
/** Factor per pixel of the wheel, as a natural logarithm. */
const ZOOM_PER_PX = 0.001;
/** Smallest height of the poster as a fraction of the view. */
const MIN_HEIGHT = 0.1;

const STEPS: Readonly<Record<string, readonly [x: number, y: number]>> = {
  ArrowLeft: [-KEY_STEP, 0],
  ArrowRight: [KEY_STEP, 0],
  ArrowUp: [0, -KEY_STEP],
  ArrowDown: [0, KEY_STEP],
};

/** Frame of the poster over the preview: the pointer drags it, the wheel sizes it. Around it, the preview takes the pointer as always. */
export function PosterGuide() {
  const { viewer } = useEditor();
  const framing = useStore(viewer, (state) => state.framing);
  return framing ? <Guide /> : null;
}

function Guide() {
  const editor = useEditor();
  const { preview, viewer, document } = editor;
  const status = useStore(preview, (state) => state.status);
  const tangents = status?.tangents ?? null;
  const views = useStore(preview, (state) => (chosenSource(state)?.kind === 'room' ? state.views : 1));
  const [chosen, setChosen] = useState<{ readonly center: readonly [number, number]; readonly height: number } | null>(null);
  const drag = useRef<{ readonly x: number; readonly y: number } | null>(null);

  const viewShape = tangents ? (tangents.right - tangents.left) / (tangents.top - tangents.bottom) : 1;
  const kept = document.getState().project.page.framing;
  const cropNow = (): ViewCrop => {
    if (chosen) return cropAt(chosen.center, chosen.height, SHAPE / viewShape);
    return kept && tangents ? cropOf(kept, tangents, SHAPE) : cropAt([0.5, 0.5], 1, SHAPE / viewShape);
  };
  const crop = cropNow();
  const change = (dx: number, dy: number, factor: number) => {
    const height = Math.min(Math.max(crop.height * factor, MIN_HEIGHT), 1);
    setChosen({ center: [crop.x + crop.width / 2 + dx, crop.y + crop.height / 2 + dy], height });
  };
  const zoom = useRef(change);
  zoom.current = change;
  const listen = useCallback((element: HTMLDivElement) => {
    // React listens passively, so that the page would scroll as well.
    const onWheel = (event: WheelEvent) => {
      event.preventDefault();
      zoom.current(0, 0, Math.exp(event.deltaY * ZOOM_PER_PX));
    };
    element.addEventListener('wheel', onWheel, { passive: false });
    element.focus({ preventScroll: true });
    return () => element.removeEventListener('wheel', onWheel);
  }, []);
  if (!tangents || !status) return null;

  const leave = () => viewer.setState({ framing: false });
  const use = () => {
    keepFraming(editor, crop, status);
    leave();
  };
  const onPointerMove = (event: PointerEvent<HTMLElement>) => {
    const box = event.currentTarget.parentElement?.getBoundingClientRect();
    if (!drag.current || !box) return;
    change((event.clientX - drag.current.x) / box.width, (event.clientY - drag.current.y) / box.height, 1);
    drag.current = { x: event.clientX, y: event.clientY };
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const step = STEPS[event.key];
    if (step) change(...step, 1);
    else if (event.key === '+') change(0, 0, 1 / ZOOM_STEP);
    else if (event.key === '-') change(0, 0, ZOOM_STEP);
    else if (event.key === 'Enter') use();
    else if (event.key === 'Escape') leave();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const percent = (part: number) => `${part * 100}%`;
  return (
    <div className="poster-view" style={{ width: percent(1 / views) }}>
      <div
        ref={listen}
        className="poster-guide"
        role="slider"
        tabIndex={0}
        aria-label="Frame of the poster. Arrow keys move it, plus and minus size it, Enter uses it."
        aria-valuemin={MIN_HEIGHT * 100}
        aria-valuemax={100}
        aria-valuenow={Math.round(crop.height * 100)}
        aria-valuetext={`${Math.round(crop.height * 100)} % of the height`}
        style={{ left: percent(crop.x), top: percent(crop.y), width: percent(crop.width), height: percent(crop.height) }}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          drag.current = { x: event.clientX, y: event.clientY };
        }}
        onPointerMove={onPointerMove}
        onPointerUp={() => {
          drag.current = null;
        }}
        onPointerCancel={() => {
          drag.current = null;
        }}
        onKeyDown={onKeyDown}
      />
      <div className="poster-bar" role="toolbar" aria-label="Poster">
        <IconButton icon="remove" label="Show more" small onPress={() => change(0, 0, ZOOM_STEP)} />
        <IconButton icon="add" label="Show less" small onPress={() => change(0, 0, 1 / ZOOM_STEP)} />
        <Button look="primary" onPress={use}>
          Use as poster
        </Button>
        <Button onPress={leave}>Cancel</Button>
      </div>
    </div>
  );
}
