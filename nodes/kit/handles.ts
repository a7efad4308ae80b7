/**
 * The part of the gizmo that changes a param. `position`, `rotation` and `scale` are those of the node's transform: meters; angles
 * about x, y and z, applied in the order z, x, y; factors or sizes. `aim` is a point that the node faces. `azimuth` and `elevation` are
 * the direction that light comes from. `step`, `radius` and `turn` arrange copies: the offset from one copy to the next, the distance
 * from the middle along z, and the angle about y that each copy adds to the one before. They belong to the node itself, not to the nodes
 * before it.
 */
export type Handle = 'position' | 'rotation' | 'scale' | 'aim' | 'azimuth' | 'elevation' | 'step' | 'radius' | 'turn';

/** The axes of a handle by the value of a choice of the same node, as in `xz`. There is no handle for values that are not listed. */
export interface HandleAxes {
  readonly param: string;
  readonly axes: Readonly<Record<string, string>>;
}
