import { useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import type { PickRequest } from '../state/editor/viewer.ts';
import { Icon } from '../ui/icon.tsx';

interface EyedropperButtonProps {
  /** Label of the param that gets the color. */
  readonly label: string;
  /** Called with display-referred sRGB, each component in [0, 1]. */
  readonly onTake: (color: readonly [number, number, number]) => void;
}

/** Toggles the eyedropper, which picks a color from the preview. */
export function EyedropperButton({ label, onTake }: EyedropperButtonProps) {
  const { viewer } = useEditor();
  const button = useRef<HTMLButtonElement>(null);
  const mine = useRef<PickRequest | null>(null);
  const picking = useStore(viewer, (state) => state.picking !== null && state.picking === mine.current);
  const take = useRef(onTake);
  take.current = onTake;
  useEffect(
    () => () => {
      if (mine.current !== null && viewer.getState().picking === mine.current) viewer.setState({ picking: null });
    },
    [viewer],
  );
  const press = () => {
    const takeColor: PickRequest['take'] = ({ color: [r, g, b] }) => take.current([r / 255, g / 255, b / 255]);
    mine.current = picking ? null : { label, what: 'color', layer: null, take: takeColor, onEnd: () => button.current?.focus() };
    viewer.setState({ picking: mine.current, probed: null });
  };
  const words = `${label}: pick from the preview`;
  return (
    <button
      ref={button}
      type="button"
      className="icon-button icon-button-small"
      aria-label={words}
      aria-pressed={picking}
      data-tip={words}
      // The eyedropper closes when it loses the focus; the click on this button must close it instead of reopening it.
      onMouseDown={(event) => event.preventDefault()}
      onClick={press}
    >
      <Icon name="probe" size={14} />
    </button>
  );
}
