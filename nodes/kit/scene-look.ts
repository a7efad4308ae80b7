import type { Object3D } from 'three';
import type { ObjectItem, ObjectList, RoomDepthOutput } from './scene-lists.ts';
import type { NumberView, VectorView } from './value-views.ts';

/** What a scene draws each of its objects with. */
export type SceneLook =
  /**
   * Virtual objects with their own materials, lit and shadowed; phantoms as depth alone. `ambient` is the brightness of the neutral
   * surroundings that light them besides their lights: 1, as when absent, makes a white matt surface white by them alone.
   */
  | { readonly kind: 'shaded'; readonly ambient?: NumberView }
  /** Objects as shadow catchers: one color, with alpha where light is blocked. */
  | ShadowCatcherLook
  /**
   * Virtual objects flat and white, whatever their materials, as far as `shows` says of them and of the parts they are made of; all
   * others, and phantoms, as depth alone. Asked when a list has changed.
   */
  | { readonly kind: 'mask'; readonly shows: (item: ObjectItem, part: Object3D) => boolean };

export interface ShadowCatcherLook {
  readonly kind: 'shadow-catcher';
  readonly strength: NumberView;
  readonly color: VectorView;
  /** What catches them; virtual objects are not drawn unless `everything` does. Absent: phantoms. */
  readonly on?: 'phantoms' | 'everything';
  /** What casts, where shadow volumes are to be used; absent, the shadow maps of the operation are. */
  readonly volumesOf?: readonly ObjectList[];
  /**
   * Depth of the real room, and how far behind it something may lie and still catch shadows: what the depth shows catches them where
   * nothing else does, by shadow maps, and what lies behind it catches none.
   */
  readonly room?: { readonly depth: RoomDepthOutput; readonly toleranceM: NumberView };
}
