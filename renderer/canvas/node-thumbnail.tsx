import { useEffect, useRef } from 'react';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { layerName } from '../state/editor/layer-names.ts';
import './node-thumbnail.css';

/** Thumbnail of a layer. React Flow mounts only visible nodes, so only visible layers are requested; bitmaps bypass React. */
export function NodeThumbnail({ node, port }: { readonly node: string; readonly port: string }) {
  const { thumbnails } = useEditor();
  const layer = useDocument((state) => layerName(state, node, port));
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(
    () =>
      thumbnails.watch(layer, (picture) => {
        const element = canvas.current;
        if (!element) return picture.close();
        element.width = picture.width;
        element.height = picture.height;
        element.getContext('bitmaprenderer')?.transferFromImageBitmap(picture);
      }),
    [thumbnails, layer],
  );
  return (
    <div className="node-picture">
      <canvas ref={canvas} width="0" height="0" />
    </div>
  );
}
