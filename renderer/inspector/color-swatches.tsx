import { useEffect, useMemo, useRef, useState } from 'react';
import { useDocument } from '../state/editor/editor-context.ts';
import { projectColors } from '../state/params/project-colors.ts';
import { colorFromHex, hexFromColor, type Rgba } from '../ui/color-text.ts';

interface ColorSwatchesProps {
  readonly label: string;
  readonly value: Rgba;
  readonly onChoose: (color: Rgba) => void;
  /** Called with the color that the pointer rests on; null when it leaves. */
  readonly onPoint: (color: Rgba | null) => void;
}

/** One row of the inspector at its narrowest. */
const MOST = 8;

/** The colors that other params of the project have; a press uses one, with the alpha of the param. */
export function ColorSwatches({ label, value, onChoose, onPoint }: ColorSwatchesProps) {
  const project = useDocument((state) => state.project);
  const library = useDocument((state) => state.library);
  const colors = useMemo(() => projectColors(project, library, MOST + 1), [project, library]);
  const own = hexFromColor(value);
  const others = colors.filter((color) => color !== own).slice(0, MOST);
  const [isPointed, setPointed] = useState(false);
  const pointed = useRef(onPoint);
  pointed.current = onPoint;
  const point = (color: Rgba | null) => {
    setPointed(color !== null);
    onPoint(color);
  };
  // The swatches may go with the node, or with the last other color, while the pointer rests on one.
  const shown = isPointed && others.length > 0;
  useEffect(() => (shown ? () => pointed.current(null) : undefined), [shown]);
  if (others.length === 0) return null;
  return (
    <fieldset className="color-swatches" aria-label={`${label}, colors of the project`}>
      {others.map((hex) => {
        const color = colorFromHex(hex, value[3]) ?? value;
        return (
          <button
            key={hex}
            type="button"
            className="color-swatch"
            aria-label={`Use ${hex}`}
            data-tip={hex}
            style={{ background: hex }}
            onPointerEnter={() => point(color)}
            onPointerLeave={() => point(null)}
            onClick={() => {
              point(null);
              onChoose(color);
            }}
          />
        );
      })}
    </fieldset>
  );
}
