import { useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../shell/editor-context.ts';
import type { ColorWish } from '../state/looks.ts';
import { Icon } from '../ui/icon.tsx';

interface PipetteProps {
  /** What the colour is for. */
  readonly label: string;
  readonly onTake: ColorWish['take'];
}

/** Takes a colour from the preview: the eyedropper lies over its picture until it has one, or until this is pressed again. */
export function Pipette({ label, onTake }: PipetteProps) {
  const { look } = useEditor();
  const button = useRef<HTMLButtonElement>(null);
  const mine = useRef<ColorWish | null>(null);
  const picking = useStore(look, (state) => state.picking !== null && state.picking === mine.current);
  const take = useRef(onTake);
  take.current = onTake;
  useEffect(
    () => () => {
      if (mine.current !== null && look.getState().picking === mine.current) look.setState({ picking: null });
    },
    [look],
  );
  const press = () => {
    mine.current = picking ? null : { label, take: (color) => take.current(color), onEnd: () => button.current?.focus() };
    look.setState({ picking: mine.current, probed: null });
  };
  const words = `${label}: take it from the preview`;
  return (
    <button
      ref={button}
      type="button"
      className="icon-button icon-button-small"
      aria-label={words}
      aria-pressed={picking}
      data-tip={words}
      // The eyedropper ends when it loses the focus; this press shall end it itself.
      onMouseDown={(event) => event.preventDefault()}
      onClick={press}
    >
      <Icon name="probe" size={14} />
    </button>
  );
}
