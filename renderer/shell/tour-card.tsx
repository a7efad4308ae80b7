import { type KeyboardEvent, useEffect, useId, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { endTour, stepTour, TOUR, type TourStep } from '../state/commands/tour.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { uiScale } from '../ui/appearance.ts';
import { Button } from '../ui/button.tsx';
import './tour-card.css';

/** The current step of the tour, if any. */
export function Tour() {
  const { ui } = useEditor();
  const tour = useStore(ui, (state) => state.tour);
  const step = tour === null ? undefined : TOUR[tour];
  return step && tour !== null ? <TourCard key={tour} step={step} number={tour} /> : null;
}

interface Box {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** Card beside its subject, which is outlined. It is not modal, so that the subject stays usable. */
function TourCard({ step, number }: { readonly step: TourStep; readonly number: number }) {
  const editor = useEditor();
  const card = useRef<HTMLElement>(null);
  const titleId = useId();
  const about = useBox(step.about);
  const [size, setSize] = useState({ width: 320, height: 180 });
  useEffect(() => {
    const element = card.current;
    if (!element) return;
    const { width, height } = element.getBoundingClientRect();
    setSize({ width, height });
    element.querySelector<HTMLElement>('[data-autofocus]')?.focus();
  }, []);
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key === 'Escape') endTour(editor);
    else if (event.key === 'ArrowRight') stepTour(editor, 1);
    else if (event.key === 'ArrowLeft') stepTour(editor, -1);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const isLast = number === TOUR.length - 1;
  return (
    <>
      {about && <div className="tour-frame" style={{ ...about }} aria-hidden="true" />}
      <section
        ref={card}
        className="tour-card"
        role="dialog"
        aria-labelledby={titleId}
        style={about ? inOwnPx(placeBeside(about, size)) : { left: 24, top: 80 }}
        onKeyDown={onKeyDown}
      >
        <p className="tour-count">
          {number + 1} of {TOUR.length}
        </p>
        <h2 id={titleId}>{step.title}</h2>
        <p>{step.text}</p>
        <div className="tour-actions">
          {!isLast && (
            <Button look="quiet" onPress={() => endTour(editor)}>
              Skip
            </Button>
          )}
          <span className="tour-gap" />
          {number > 0 && <Button onPress={() => stepTour(editor, -1)}>Back</Button>}
          <Button look="primary" autoFocus onPress={() => stepTour(editor, 1)}>
            {isLast ? 'Done' : 'Next'}
          </Button>
        </div>
      </section>
    </>
  );
}

/** Client rectangle of an element, updated on resize; null if there is none. */
function useBox(selector: string): Box | null {
  const [box, setBox] = useState<Box | null>(null);
  useEffect(() => {
    const element = document.querySelector(selector);
    if (!element) return;
    const measure = () => {
      const { left, top, width, height } = element.getBoundingClientRect();
      setBox({ left, top, width, height });
    };
    measure();
    const watch = new ResizeObserver(measure);
    watch.observe(element);
    watch.observe(document.documentElement);
    return () => watch.disconnect();
  }, [selector]);
  return box;
}

/** Converts client pixels to CSS pixels of the scaled card. */
function inOwnPx({ left, top }: { readonly left: number; readonly top: number }) {
  const scale = uiScale();
  return { left: left / scale, top: top / scale };
}

const GAP_PX = 14;
const EDGE_PX = 16;

/** Position left of the subject, else below it, else in its corner. Client pixels. */
function placeBeside(about: Box, size: { readonly width: number; readonly height: number }) {
  const within = (value: number, most: number) => Math.max(EDGE_PX, Math.min(value, most - EDGE_PX));
  const top = within(about.top, window.innerHeight - size.height);
  const left = about.left - size.width - GAP_PX;
  if (left >= EDGE_PX) return { left, top: within(top, window.innerHeight - size.height) };
  const below = about.top + about.height + GAP_PX;
  if (below + size.height <= window.innerHeight) return { left: within(about.left, window.innerWidth - size.width), top: below };
  return { left: about.left + EDGE_PX, top: about.top + EDGE_PX };
}
