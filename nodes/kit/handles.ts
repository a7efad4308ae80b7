/**
 * The part of the gizmo that changes a param. `position`, `rotation` and `scale` are those of the node's transform: meters; angles
 * about x, y and z, applied in the order z, x, y; factors or sizes. `aim` is a point that the node faces. `azimuth` and `elevation` are
 * the direction that light comes from. `step`, `radius` and `turn` arrange copies: the offset from one copy to the next, the distance
 * from the middle along z, and the angle about y that each copy adds to the one before. They belong to the node itself, not to the nodes
 * before it. The handles of images place a filter in its layer, with the origin at the bottom left: see `IMAGE_HANDLES`.
 */
export type Handle = ImageHandle | 'position' | 'rotation' | 'scale' | 'aim' | 'azimuth' | 'elevation' | 'step' | 'radius' | 'turn';

/** The axes of a handle by the value of a choice of the same node, as in `xz`. There is no handle for values that are not listed. */
export interface HandleAxes {
  readonly param: string;
  readonly axes: Readonly<Record<string, string>>;
}

/**
 * The part of a gizmo in an image that changes a param. `center`: a point, in UV. `extent`: the radius of a circle around it, in pixels of
 * the layer. `angle`: an angle around it, counterclockwise from the right. `low` and `high`: the bottom left and the top right corner of a
 * rectangle, in UV. `size`: width and height of a shape around the center, rotated by the angle; `feather`: the width of its soft edge,
 * half of it outside; both as fractions of the height of the layer.
 */
export type ImageHandle = (typeof IMAGE_HANDLES)[number];

export const IMAGE_HANDLES = ['center', 'extent', 'angle', 'low', 'high', 'size', 'feather'] as const;

/** The handles that a param of a type can have in an image. */
export const IMAGE_HANDLES_OF = { number: ['extent', 'angle', 'feather'], vector2: ['center', 'low', 'high', 'size'] } as const;

/** Whether a param of this type can have this handle in an image. */
export function isImageHandleOf<Type extends keyof typeof IMAGE_HANDLES_OF>(
  type: Type,
  handle: string | null,
): handle is (typeof IMAGE_HANDLES_OF)[Type][number] {
  return IMAGE_HANDLES_OF[type].some((known) => known === handle);
}

export function isImageHandle(handle: string): handle is ImageHandle {
  return IMAGE_HANDLES.some((known) => known === handle);
}
