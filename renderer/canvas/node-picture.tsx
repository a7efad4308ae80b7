import { useEffect, useRef } from 'react';
import { useDocument, useEditor } from '../shell/editor-context.ts';
import { layerName } from '../state/looks.ts';
import './node-picture.css';

/** What a layer looks like now. Only nodes on screen are there, so only their layers are asked for; React draws none of them. */
export function NodePicture({ node, port }: { readonly node: string; readonly port: string }) {
  const { pictures } = useEditor();
  const layer = useDocument((state) => layerName(state, node, port));
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(
    () =>
      pictures.layers.watch(layer, (picture) => {
        const element = canvas.current;
        if (!element) return picture.close();
        element.width = picture.width;
        element.height = picture.height;
        element.getContext('bitmaprenderer')?.transferFromImageBitmap(picture);
      }),
    [pictures, layer],
  );
  return (
    <div className="node-picture">
      <canvas ref={canvas} width="0" height="0" />
    </div>
  );
}
