import { type KeyboardEvent, type PointerEvent, useLayoutEffect, useRef } from 'react';
import { getOwn } from '../../export/graph/record.ts';
import type { FoundLamps } from '../../nodes/kit/panorama/found-lamps.ts';
import { useUndoGroup } from '../state/document/use-undo-group.ts';
import { nodeOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { directionAtPlace, directionOf, MAX_CHANGED, moveLamp, type PanoramaPlace, placeOf } from '../state/lamps/edit-lamps.ts';
import type { LampStage } from '../state/lamps/messages.ts';

interface LampImageProps {
  readonly id: string;
  readonly found: FoundLamps;
  readonly stage: LampStage;
  /** The step of the search that `stage` shows. Its contours are drawn; if undefined, those of the lamps. */
  readonly step: FoundLamps['steps'][number] | undefined;
  /** Number of the selected lamp, from 1. */
  readonly chosen: number;
  readonly onChoose: (lamp: number) => void;
}

/** A step of the search with contours, and the lamps as numbers that can be dragged. */
export function LampImage({ id, found, stage, step, chosen, onChoose }: LampImageProps) {
  const { widthPx, heightPx, lamps } = found;
  const canvas = useRef<HTMLCanvasElement>(null);
  const { image } = stage;
  useLayoutEffect(() => {
    canvas.current?.getContext('2d')?.drawImage(image, 0, 0);
  }, [image]);
  const contours = step ? step.contours : lamps.map(({ contour }) => contour);
  return (
    <div className="lamps-image">
      <canvas ref={canvas} width={image.width} height={image.height} />
      <svg viewBox={`-.5 -.5 ${widthPx} ${heightPx}`} preserveAspectRatio="none" aria-hidden="true">
        {contours.map((contour) => (
          <polygon key={`${contour[0]} ${contour[1]}`} points={contour.join(' ')} />
        ))}
      </svg>
      {lamps.map((lamp, i) => (
        <LampMark
          key={lamp.centerPx.join(' ')}
          id={id}
          lamp={i + 1}
          found={placeOf(directionOf(lamp))}
          isChosen={chosen === i + 1}
          onChoose={() => onChoose(i + 1)}
        />
      ))}
    </div>
  );
}

interface LampMarkProps {
  readonly id: string;
  readonly lamp: number;
  readonly found: PanoramaPlace;
  readonly isChosen: boolean;
  readonly onChoose: () => void;
}

/** Distance by which an arrow key moves a lamp, as a fraction of the width or height of the panorama: 1°. */
const KEY_X = 1 / 360;
const KEY_Y = 1 / 180;
const KEYS: Readonly<Record<string, PanoramaPlace>> = {
  ArrowLeft: { x: -KEY_X, y: 0 },
  ArrowRight: { x: KEY_X, y: 0 },
  ArrowUp: { x: 0, y: -KEY_Y },
  ArrowDown: { x: 0, y: KEY_Y },
};

/** Mark with the number of a lamp, at the centroid of the lamp or where it is pinned. */
function LampMark({ id, lamp, found, isChosen, onChoose }: LampMarkProps) {
  const editor = useEditor();
  const place = usePinned(id, lamp) ?? found;
  const gesture = useUndoGroup<PanoramaPlace>((to) => moveLamp(editor, id, lamp, directionAtPlace(to)));
  const isMovable = lamp <= MAX_CHANGED;
  const drag = (event: PointerEvent<HTMLButtonElement>) => {
    const box = event.currentTarget.parentElement?.getBoundingClientRect();
    if (!isMovable || !box || !event.currentTarget.hasPointerCapture(event.pointerId)) return;
    gesture.onEdit({ x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height });
  };
  const press = (event: KeyboardEvent) => {
    const step = KEYS[event.key];
    if (!step || !isMovable) return;
    event.preventDefault();
    gesture.onEdit({ x: place.x + step.x, y: place.y + step.y });
    gesture.onEnd();
  };
  return (
    <button
      type="button"
      className={isChosen ? 'lamps-mark lamps-chosen' : 'lamps-mark'}
      style={{ left: `${place.x * 100}%`, top: `${place.y * 100}%` }}
      aria-label={`Lamp ${lamp}`}
      aria-pressed={isChosen}
      onClick={onChoose}
      onKeyDown={press}
      onPointerDown={(event) => {
        onChoose();
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={drag}
      onPointerUp={gesture.onEnd}
      onPointerCancel={gesture.onCancel}
    >
      {lamp}
    </button>
  );
}

/** The position where a lamp is pinned; null if it is not pinned, or if its direction follows a track or expression. */
function usePinned(id: string, lamp: number): PanoramaPlace | null {
  const text = useDocument((state) => {
    const params = nodeOf(state, id)?.params ?? {};
    const definition = state.library.definition(nodeOf(state, id)?.type ?? '');
    const readParam = (name: string): unknown => {
      const binding = getOwn(params, name);
      if (binding === undefined) return definition?.params[name]?.default;
      return 'value' in binding ? binding.value : 'port' in binding ? binding.port : null;
    };
    return JSON.stringify([readParam(`lamp${lamp}Pinned`), readParam(`lamp${lamp}AzimuthRad`), readParam(`lamp${lamp}ElevationRad`)]);
  });
  const [isPinned, azimuthRad, elevationRad] = JSON.parse(text) as unknown[];
  return isPinned === true && typeof azimuthRad === 'number' && typeof elevationRad === 'number'
    ? placeOf({ azimuthRad, elevationRad })
    : null;
}
