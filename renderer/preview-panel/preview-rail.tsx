import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import { chooseFrame, type DeviceFrame, shownFrame } from '../state/editor/preview-state.ts';
import { Icon, type IconName } from '../ui/icon.tsx';
import { GizmoBar } from './gizmo-bar.tsx';
import './preview-rail.css';

const FRAMES: readonly { readonly frame: DeviceFrame; readonly label: string; readonly icon: IconName }[] = [
  { frame: 'fill', label: 'Fit to panel', icon: 'fit-panel' },
  { frame: 'phone', label: 'Phone, portrait', icon: 'phone' },
  { frame: 'phone-wide', label: 'Phone, landscape', icon: 'phone-wide' },
  { frame: 'headset', label: 'Headset', icon: 'headset' },
  { frame: 'glasses', label: 'Glasses (additive display)', icon: 'glasses' },
];

/** Beside the picture, so that nothing covers it: the device frames and the tools of the gizmo. */
export function PreviewRail() {
  const { preview } = useEditor();
  const shown = useStore(preview, shownFrame);
  return (
    <div className="preview-rail">
      <div role="toolbar" aria-label="Device frame" aria-orientation="vertical">
        {FRAMES.map(({ frame, label, icon }) => (
          <button
            key={frame}
            type="button"
            className="gizmo-tool"
            aria-label={label}
            aria-pressed={shown === frame}
            data-tip={label}
            onClick={() => chooseFrame(preview, frame)}
          >
            <Icon name={icon} />
          </button>
        ))}
      </div>
      <GizmoBar />
    </div>
  );
}
