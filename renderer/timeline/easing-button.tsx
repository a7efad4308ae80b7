import { useRef, useState } from 'react';
import { type Easing, type Handles, handlesOf } from '../../nodes/kit/ease.ts';
import { useUndoGroup } from '../state/document/use-undo-group.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { setEasing } from '../state/params/keyframes.ts';
import { CurveDrawing } from '../ui/curve-square.tsx';
import { Popover } from '../ui/popover.tsx';
import { EasingEditor, easingPath } from './easing-editor.tsx';
import type { ChosenKeyframe } from './keyframe-mark.tsx';

interface EasingButtonProps extends ChosenKeyframe {
  readonly easing: Easing;
}

/** Thumbnail of an easing that opens its control points. Disabled for `step`, which has none. */
export function EasingButton({ node, param, index, easing }: EasingButtonProps) {
  const editor = useEditor();
  const from = useRef<HTMLSpanElement>(null);
  const [open, setOpen] = useState(false);
  const gesture = useUndoGroup<Handles>((value) => void setEasing(editor, node, param, index, value));
  const handles = handlesOf(easing);
  return (
    <span ref={from} className="easing-open">
      <button
        type="button"
        aria-label="Edit Bézier curve"
        aria-haspopup="dialog"
        aria-expanded={open && handles !== null}
        data-tip={handles === null ? 'Hold has no Bézier curve' : 'Edit Bézier curve'}
        disabled={handles === null}
        onClick={() => setOpen(!open)}
      >
        <CurveDrawing path={easingPath(easing)} />
      </button>
      {open && handles !== null && (
        <Popover label="Bézier interpolation" from={from} onClose={() => setOpen(false)}>
          <EasingEditor value={handles} {...gesture} />
        </Popover>
      )}
    </span>
  );
}
