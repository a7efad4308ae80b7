import { type KeyboardEvent, type MouseEvent, useEffect, useLayoutEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import type { PreviewProbe } from '../preview-protocol.ts';
import { useEditor } from '../shell/editor-context.ts';
import { useFeed } from '../shell/feed-context.ts';
import type { ColorWish } from '../state/looks.ts';
import './eyedropper.css';
import { probeWords } from './probe-words.ts';

/** Pixels on each side of the one in the middle: eleven in a row, each ten points wide. */
const AROUND_PX = 5;
const SIDE_PX = 2 * AROUND_PX + 1;
/** With Shift held. */
const LONG_STEP_PX = 10;

/** Parts of the picture's size from the top left. */
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
 * Lies over the preview while somebody waits for a colour of it: what is under the pointer is shown large, a click takes it. Arrow keys
 * move from pixel to pixel, Enter takes, Escape leaves. Nothing of it reaches the preview.
 */
export function Eyedropper({ wish }: { readonly wish: ColorWish }) {
  const { look, preview } = useEditor();
  const feed = useFeed();
  const layer = useRef<HTMLDivElement>(null);
  const [at, setAt] = useState<Point>({ x: 0.5, y: 0.5 });
  const [taking, setTaking] = useState<Point | null>(null);
  const probed = useStore(look, (state) => state.probed);

  useEffect(() => {
    layer.current?.focus({ preventScroll: true });
  }, []);
  useEffect(() => feed.send({ kind: 'probe', ...at, layer: null, aroundPx: AROUND_PX }), [feed, at]);
  useEffect(() => {
    // What is seen large is what is taken, also of a picture that moves.
    if (taking === null || probed === null || probed.x !== taking.x || probed.y !== taking.y) return;
    const [r, g, b] = probed.color;
    look.setState({ picking: null, probed: null });
    wish.take([r / 255, g / 255, b / 255]);
    wish.onEnd();
  }, [taking, probed, look, wish]);

  const leave = () => {
    if (look.getState().picking === wish) look.setState({ picking: null, probed: null });
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
      wish.onEnd();
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
      ref={layer}
      className="eyedropper"
      role="application"
      tabIndex={-1}
      aria-label={`${wish.label}: take a colour from the preview. Arrow keys move, Enter takes, Escape leaves.`}
      onPointerMove={(event) => setAt(pointOf(event))}
      // Not at the press: this would be gone, and the preview get the rest of the click.
      onClick={(event) => {
        setAt(pointOf(event));
        setTaking(pointOf(event));
      }}
      onContextMenu={(event) => {
        event.preventDefault();
        leave();
        wish.onEnd();
      }}
      onKeyDown={onKeyDown}
      onBlur={leave}
    >
      {probed && <Loupe probed={probed} at={at} />}
    </div>
  );
}

/** To the middle of another pixel. */
function stepped(part: number, by: number, sizePx: number): number {
  return (Math.min(Math.max(Math.floor(part * sizePx) + by, 0), sizePx - 1) + 0.5) / sizePx;
}

/** The pixels around the point, large, with the value of the middle one. */
function Loupe({ probed, at }: { readonly probed: PreviewProbe; readonly at: Point }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const { around } = probed;
  // With the words, not a paint after them.
  useLayoutEffect(() => {
    const context = canvas.current?.getContext('2d');
    if (context && around) context.putImageData(new ImageData(around, SIDE_PX, SIDE_PX), 0, 0);
  }, [around]);
  const [r, g, b] = probed.color;
  const { css } = probeWords(probed);
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
      <output className="loupe-words" aria-label="Colour that a click takes">
        <span className="look-swatch" style={{ background: css }} />
        {css}
        <span>{`${r} ${g} ${b}`}</span>
      </output>
    </div>
  );
}
