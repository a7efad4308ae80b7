import type { KeyboardEvent, PointerEvent } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { useFeed } from '../shell/feed-context.ts';
import { layerTitle, lookAtNothing, probedLayer } from '../state/looks.ts';
import { IconButton } from '../ui/button.tsx';
import { Eyedropper } from './eyedropper.tsx';
import './look-layer.css';
import { probeWords } from './probe-words.ts';

const KEY_STEP = 0.02;

/** What lies over the preview's picture: which layers it shows, the wipe between them, and what is under the pointer. */
export function LookLayer() {
  const { look } = useEditor();
  const pinned = useStore(look, (state) => state.left !== null);
  const wiping = useStore(look, (state) => state.split !== null);
  const picking = useStore(look, (state) => state.picking);
  const probing = useStore(look, (state) => state.probing && state.picking === null);
  return (
    <>
      {probing && <Probe />}
      {pinned && wiping && <Wipe />}
      {pinned && <Pinned />}
      {picking && <Eyedropper key={picking.label} wish={picking} />}
    </>
  );
}

function Pinned() {
  const editor = useEditor();
  const { left, right, split } = useStore(editor.look);
  const words = useDocument((state) => `${layerTitle(state, left)}${split === null ? '' : ` | ${layerTitle(state, right)}`}`);
  return (
    <div className="look-pinned">
      <span>{words}</span>
      <IconButton icon="close" label="Show the screen again" small onPress={() => lookAtNothing(editor.look)} />
    </div>
  );
}

/** Divides the picture; dragged, or moved by the arrow keys. */
function Wipe() {
  const { look } = useEditor();
  const split = useStore(look, (state) => state.split ?? 1);
  const move = (to: number) => look.setState({ split: Math.min(1, Math.max(0, to)) });
  const onPointerMove = (event: PointerEvent<HTMLElement>) => {
    const box = event.currentTarget.parentElement?.getBoundingClientRect();
    if (box && event.currentTarget.hasPointerCapture(event.pointerId)) move((event.clientX - box.left) / box.width);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
    event.preventDefault();
    move(split + (event.key === 'ArrowRight' ? KEY_STEP : -KEY_STEP));
  };
  return (
    <div
      className="look-wipe"
      style={{ left: `${split * 100}%` }}
      role="slider"
      tabIndex={0}
      aria-label="Wipe between the two layers"
      aria-orientation="horizontal"
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(split * 100)}
      onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
      onPointerMove={onPointerMove}
      onKeyDown={onKeyDown}
    />
  );
}

/** Asks for what is under the pointer, and says it beside. */
function Probe() {
  const editor = useEditor();
  const feed = useFeed();
  const probed = useStore(editor.look, (state) => state.probed);
  const ask = (event: PointerEvent<HTMLElement>) => {
    const box = event.currentTarget.getBoundingClientRect();
    const [x, y] = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    feed.send({ kind: 'probe', x, y, layer: probedLayer(editor) });
  };
  const words = probed && probeWords(probed);
  return (
    <div className="look-probe" onPointerMove={ask} onPointerDown={ask}>
      {probed && words && (
        <output className="look-probed" data-side={probed.x > 0.5 ? 'left' : 'right'} aria-label="Under the pointer">
          <span className="look-swatch" style={{ background: words.css }} />
          {words.lines.map((line) => (
            <span key={line}>{line}</span>
          ))}
        </output>
      )}
    </div>
  );
}
