import { type KeyboardEvent, type MouseEvent, useEffect, useLayoutEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import type { PreviewProbe } from '../preview-protocol.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import type { PickRequest } from '../state/editor/viewer.ts';
import { usePreviewSync } from '../state/preview-sync/preview-sync-context.ts';
import './eyedropper.css';

/** Number of pixels that the magnifier shows on each side of the center: 11 in a row, each 10 CSS pixels wide. */
const AROUND_PX = 5;
const SIDE_PX = 2 * AROUND_PX + 1;
/** Step of the arrow keys with Shift, in pixels. */
const LONG_STEP_PX = 10;

/** Fractions of the preview size, from the top left. */
interface Point {
  readonly x: number;
  readonly y: number;
}

const STEPS: Readonly<Record<string, readonly [x: number, y: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/**
 * Overlay that picks a color or a point from the preview, with a magnifier. A click or Enter picks, arrow keys move by pixels, Escape cancels. No input
 * reaches the preview.
 */
export function Eyedropper({ request }: { readonly request: PickRequest }) {
  const { viewer, preview } = useEditor();
  const previewSync = usePreviewSync();
  const overlay = useRef<HTMLDivElement>(null);
  const { layer } = request;
  const [at, setAt] = useState<Point>({ x: 0.5, y: 0.5 });
  const [taking, setTaking] = useState<Point | null>(null);
  const probed = useStore(viewer, (state) => state.probed);

  useEffect(() => {
    overlay.current?.focus({ preventScroll: true });
  }, []);
  useEffect(
    () => previewSync.send({ kind: 'probe', ...at, layer, ofLayer: layer !== null, aroundPx: AROUND_PX }),
    [previewSync, at, layer],
  );
  useEffect(() => {
    // Picks the color that the magnifier shows, also while the preview plays.
    if (taking === null || probed === null || probed.x !== taking.x || probed.y !== taking.y) return;
    viewer.setState({ picking: null, probed: null });
    request.take(probed);
    request.onEnd();
  }, [taking, probed, viewer, request]);

  const leave = () => {
    if (viewer.getState().picking === request) viewer.setState({ picking: null, probed: null });
  };
  const pointOf = (event: MouseEvent<HTMLElement>): Point => {
    const box = event.currentTarget.getBoundingClientRect();
    return { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height };
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const step = STEPS[event.key];
    const { widthPx = 1, heightPx = 1 } = preview.getState().status ?? {};
    if (event.key === 'Escape') {
      leave();
      request.onEnd();
    } else if (event.key === 'Enter' || event.key === ' ') setTaking(at);
    else if (step) {
      const by = event.shiftKey ? LONG_STEP_PX : 1;
      setAt({ x: stepped(at.x, step[0] * by, widthPx), y: stepped(at.y, step[1] * by, heightPx) });
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div
      ref={overlay}
      className="eyedropper"
      role="application"
      tabIndex={-1}
      aria-label={`${request.label}: pick a ${request.what} from the preview. Arrow keys move, Enter picks, Escape cancels.`}
      onPointerMove={(event) => setAt(pointOf(event))}
      // Not on `pointerdown`: the overlay would disappear, and the preview would receive the rest of the click.
      onClick={(event) => {
        setAt(pointOf(event));
        setTaking(pointOf(event));
      }}
      onContextMenu={(event) => {
        event.preventDefault();
        leave();
        request.onEnd();
      }}
      onKeyDown={onKeyDown}
      onBlur={leave}
    >
      {probed && <Loupe probed={probed} at={at} what={request.what} />}
    </div>
  );
}

/** Moves a coordinate, given as a fraction of `sizePx`, by whole pixels to the center of a pixel. */
function stepped(part: number, by: number, sizePx: number): number {
  return (Math.min(Math.max(Math.floor(part * sizePx) + by, 0), sizePx - 1) + 0.5) / sizePx;
}

/** Magnifier: the pixels around the pointer, and the value of the pixel under it. */
function Loupe({ probed, at, what }: { readonly probed: PreviewProbe; readonly at: Point; readonly what: PickRequest['what'] }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const { around } = probed;
  // Draws before the paint that shows the new text.
  useLayoutEffect(() => {
    const context = canvas.current?.getContext('2d');
    if (context && around) context.putImageData(new ImageData(around, SIDE_PX, SIDE_PX), 0, 0);
  }, [around]);
  const [r, g, b] = probed.color;
  const { css, lines } = probeWords(probed);
  return (
    <div
      className="loupe"
      data-side={at.x > 0.5 ? 'left' : 'right'}
      data-above={at.y > 0.5}
      style={{ left: `${at.x * 100}%`, top: `${at.y * 100}%` }}
    >
      <span className="loupe-pixels">
        <canvas ref={canvas} width={SIDE_PX} height={SIDE_PX} />
      </span>
      <output className="loupe-words" aria-label={what === 'point' ? 'Point to pick' : 'Color to pick'}>
        {what === 'point' ? (
          lines[1]
        ) : (
          <>
            <span className="look-swatch" style={{ background: css }} />
            {css}
            <span>{`${r} ${g} ${b}`}</span>
          </>
        )}
      </output>
    </div>
  );
}

/** Text of a pixel probe: the color in hexadecimal and as 0 to 255, depth in meters. */
export function probeWords({ color: [r, g, b, a], depth }: PreviewProbe): { readonly css: string; readonly lines: readonly string[] } {
  const hex = `#${[r, g, b].map((part) => part.toString(16).padStart(2, '0')).join('')}`;
  const lines = [`${hex} · ${r} ${g} ${b}${a === 255 ? '' : ` · ${Math.round((a / 255) * 100)} % opaque`}`];
  if (depth === null) lines.push('No depth');
  else {
    lines.push(`${depth.meters.toFixed(2)} m, ${depth.of === 'room' ? 'the room' : 'the layer'}`);
    const [x, y, z] = depth.positionWorld.map((part) => part.toFixed(2));
    lines.push(`x ${x}  y ${y}  z ${z} m`);
  }
  return { css: hex, lines };
}
