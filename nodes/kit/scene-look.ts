import type { Object3D } from 'three';
import type { ObjectItem, ObjectList, RoomDepthOutput } from './scene-lists.ts';
import type { NumberView, VectorView } from './value-views.ts';

/** How a scene draws its objects. */
export type SceneLook =
  /**
   * Virtual objects with their own materials, lit and shadowed; phantoms only as depth. `ambient` is the brightness of the neutral
   * environment; at 1, the default, it alone renders a white matte surface as white.
   */
  | { readonly kind: 'shaded'; readonly ambient?: NumberView }
  /** Only the shadows on objects: one color, with alpha where light is blocked. */
  | ShadowCatcherLook
  /**
   * Virtual objects in flat white where `shows` returns true for the object and the part; all others, and phantoms, only as depth.
   * `shows` is called when a list has changed.
   */
  | { readonly kind: 'mask'; readonly shows: (item: ObjectItem, part: Object3D) => boolean };

/** Draws only shadows. */
export interface ShadowCatcherLook {
  readonly kind: 'shadow-catcher';
  readonly strength: NumberView;
  readonly color: VectorView;
  /** The objects that receive shadows. With `phantoms`, the default, virtual objects are not drawn. */
  readonly on?: 'phantoms' | 'everything';
  /** The casters, to draw with shadow volumes; absent: the shadow maps of the operation are used. */
  readonly volumesOf?: readonly ObjectList[];
  /**
   * Room depth, and how far behind it a receiver may be and still receive shadows. Real surfaces receive shadows of shadow maps where
   * there is no receiver; receivers behind them receive none.
   */
  readonly room?: { readonly depth: RoomDepthOutput; readonly toleranceM: NumberView };
}
