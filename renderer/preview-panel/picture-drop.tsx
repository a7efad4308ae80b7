import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import './picture-drop.css';

/** Says, while files are dragged over the window, what a drop on the picture does. The preview takes the drop. */
export function PictureDrop() {
  const dragged = useStore(useEditor().ui, (state) => state.fileDrags > 0);
  return (
    dragged && (
      <div className="picture-drop">
        <span>A model stands where you drop it</span>
      </div>
    )
  );
}
