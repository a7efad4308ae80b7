import { type KeyboardEvent, type PointerEvent, useState } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { layerTitle } from '../state/editor/layer-names.ts';
import { resetViewer } from '../state/editor/viewer.ts';
import { probedLayer } from '../state/preview/viewed-layers.ts';
import { usePreviewSync } from '../state/preview-sync/preview-sync-context.ts';
import { IconButton } from '../ui/button.tsx';
import { Eyedropper } from './eyedropper.tsx';
import './viewer-overlay.css';
import { probeWords } from './eyedropper.tsx';

const KEY_STEP = 0.02;

/** Overlays of the preview: titles of the viewed layers, the wipe between them, the pixel probe and the eyedropper. */
export function ViewerOverlay() {
  const { viewer } = useEditor();
  const pinned = useStore(viewer, (state) => state.left !== null);
  const wiping = useStore(viewer, (state) => state.split !== null);
  const picking = useStore(viewer, (state) => state.picking);
  const probing = useStore(viewer, (state) => state.probing && state.picking === null);
  return (
    <>
      {probing && <Probe />}
      {pinned && wiping && <Wipe />}
      {pinned && <Pinned />}
      {picking && <Eyedropper key={picking.label} request={picking} />}
    </>
  );
}

function Pinned() {
  const editor = useEditor();
  const { left, right, split } = useStore(editor.viewer);
  const words = useDocument((state) => `${layerTitle(state, left)}${split === null ? '' : ` | ${layerTitle(state, right)}`}`);
  return (
    <div className="look-pinned">
      <span>{words}</span>
      <IconButton icon="close" label="Show output" small onPress={() => resetViewer(editor.viewer)} />
    </div>
  );
}

/** Divider between the two viewed layers, moved by pointer or arrow keys. */
function Wipe() {
  const { viewer } = useEditor();
  const split = useStore(viewer, (state) => state.split ?? 1);
  const [pressed, setPressed] = useState(false);
  const move = (to: number) => viewer.setState({ split: Math.min(1, Math.max(0, to)) });
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
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        setPressed(true);
      }}
      onPointerMove={onPointerMove}
      onLostPointerCapture={() => setPressed(false)}
      onPointerUp={() => setPressed(false)}
      onKeyDown={onKeyDown}
    >
      {/* The frame of the preview belongs to another process, which would get the moves over it. */}
      {pressed && <span className="look-wipe-cover" />}
    </div>
  );
}

/** Pixel probe: shows color and depth under the pointer. */
function Probe() {
  const editor = useEditor();
  const previewSync = usePreviewSync();
  const probed = useStore(editor.viewer, (state) => state.probed);
  const ask = (event: PointerEvent<HTMLElement>) => {
    const box = event.currentTarget.getBoundingClientRect();
    const [x, y] = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    previewSync.send({ kind: 'probe', x, y, layer: probedLayer(editor) });
  };
  const words = probed && probeWords(probed);
  return (
    <div className="look-probe" onPointerMove={ask} onPointerDown={ask}>
      {probed && words && (
        <output className="look-probed" data-side={probed.x > 0.5 ? 'left' : 'right'} aria-label="Pixel under the pointer">
          <span className="look-swatch" style={{ background: words.css }} />
          {words.lines.map((line) => (
            <span key={line}>{line}</span>
          ))}
        </output>
      )}
    </div>
  );
}
