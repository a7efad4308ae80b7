import { useRef, useState } from 'react';
import { type Easing, type Handles, handlesOf } from '../../nodes/kit/ease.ts';
import { useGesture } from '../inspector/use-gesture.ts';
import { useEditor } from '../shell/editor-context.ts';
import { setEasing } from '../state/keyframes.ts';
import { CurveDrawing } from '../ui/curve-square.tsx';
import { Popover } from '../ui/popover.tsx';
import { EasingEditor } from './easing-editor.tsx';
import { easingPath } from './easing-path.ts';
import type { ChosenKey } from './key-mark.tsx';

interface EasingButtonProps extends ChosenKey {
  readonly easing: Easing;
}

/** The easing of a key as a small picture, which opens to its handles. A step has none. */
export function EasingButton({ node, param, index, easing }: EasingButtonProps) {
  const editor = useEditor();
  const from = useRef<HTMLSpanElement>(null);
  const [open, setOpen] = useState(false);
  const gesture = useGesture<Handles>((value) => void setEasing(editor, node, param, index, value));
  const handles = handlesOf(easing);
  return (
    <span ref={from} className="easing-open">
      <button
        type="button"
        aria-label="Handles of the easing"
        aria-haspopup="dialog"
        aria-expanded={open && handles !== null}
        data-tip={handles === null ? 'A step has no handles' : 'Drag the handles of the easing'}
        disabled={handles === null}
        onClick={() => setOpen(!open)}
      >
        <CurveDrawing path={easingPath(easing)} />
      </button>
      {open && handles !== null && (
        <Popover label="Easing to the next key" from={from} onClose={() => setOpen(false)}>
          <EasingEditor value={handles} {...gesture} />
        </Popover>
      )}
    </span>
  );
}
