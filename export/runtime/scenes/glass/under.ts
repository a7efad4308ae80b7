import { IDENTITY } from '../../../../nodes/kit/matrices.ts';
import type { UnderLayer } from '../../../../nodes/kit/runtime.ts';
import type { Writable } from '../../../../nodes/kit/value-views.ts';
import { layerView } from '../../resources/live-technique.ts';
import type { CreateUnder } from '../../scene-backend.ts';

export const createUnder: CreateUnder = ({ operations, presentation }, operation, resources) => {
  const lowest = operations.find((other) => 'target' in other && other.target === 'screen');
  // Of the screen, if nothing else is drawn to it before.
  const background = operation === lowest ? presentation.background : null;
  const { target, under } = operation;
  const resource = under ? resources.get(under.resource) : undefined;
  const isLayer = resource?.kind === 'target' || resource?.kind === 'external';
  const read = under && isLayer ? layerView(resource, under.fit) : null;
  const isOnScreen = target === 'screen';
  const [r, g, b, a] = background === null || background === 'world' ? [0, 0, 0, 0] : background;
  // A layer's matrix is valid only until another layer is read.
  const uvFromViewUv = Float32Array.from(IDENTITY);
  const layer: Writable<UnderLayer> = {
    texture: null,
    uvFromViewUv,
    encoding: under?.encoding ?? 'display',
    color: under === undefined && isOnScreen && a > 0 ? Float32Array.of(r * a, g * a, b * a, a) : null,
    isInTarget: isOnScreen && background !== 'world',
  };
  return ({ cameraImage }, viewIndex, widthPx, heightPx) => {
    if (read) {
      const image = read(viewIndex, widthPx, heightPx);
      layer.texture = image.texture;
      uvFromViewUv.set(image.uvFromViewUv);
    } else if (under === undefined && isOnScreen && background === 'world') {
      layer.texture = cameraImage?.texture ?? null;
      uvFromViewUv.set(cameraImage?.uvFromViewUv ?? IDENTITY);
    }
    // The room is drawn before the layer if the session has an image of it, and by the device otherwise.
    if (background === 'world') layer.isInTarget = isOnScreen && cameraImage !== null;
    return layer;
  };
};
