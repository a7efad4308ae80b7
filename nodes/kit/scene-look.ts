import type { Object3D } from 'three';
import type { LayerEncoding } from './definition.ts';
import type { ObjectItem, ObjectList, RoomDepthOutput } from './scene-lists.ts';
import type { NumberView, VectorView } from './value-views.ts';

/** How a scene draws its objects. */
export type SceneLook =
  /**
   * Virtual objects with their own materials, lit and shadowed; phantoms only as depth. `ambient` is the brightness of the neutral
   * environment; at 1, the default, it alone renders a white matte surface as white. `encoding` is that of the layer: display if absent.
   */
  | { readonly kind: 'shaded'; readonly ambient?: NumberView; readonly encoding?: LayerEncoding }
  /** Draws only the shadows on objects: one color, whose alpha is the part of the light that is blocked. */
  | ShadowCatcherLook
  /**
   * Draws virtual objects in flat white where `shows` returns true for the object and its part; all others, and phantoms, only into the
   * depth buffer. `shows` is called when a list has changed.
   */
  | { readonly kind: 'mask'; readonly shows: (item: ObjectItem, part: Object3D) => boolean };

/** The look of a scene that draws only the shadows on objects. */
export interface ShadowCatcherLook {
  readonly kind: 'shadow-catcher';
  readonly strength: NumberView;
  readonly color: VectorView;
  /** The objects that receive shadows. With `phantoms`, the default, virtual objects are not drawn. */
  readonly on?: 'phantoms' | 'everything';
  /** The casters, to draw with shadow volumes; absent: the shadow maps of the operation are used. */
  readonly volumesOf?: readonly ObjectList[];
  /** While `glow.on` is true, light is drawn around objects instead of shadows; shadows interrupt this light. Only with shadow maps. */
  readonly glow?: ShadowGlow;
  /** Draws shadows as strokes; absent: evenly. Only with shadow maps. */
  readonly strokes?: ShadowStrokes;
  /**
   * Room depth, and how far behind it a receiver may be and still receive shadows. Real surfaces receive shadows of shadow maps where
   * there is no receiver; receivers behind them receive none.
   */
  readonly room?: { readonly depth: RoomDepthOutput; readonly toleranceM: NumberView };
}

/** The most spots of a glow. There is one spot per object and light. */
export const MAX_GLOW_SPOTS = 16;

/**
 * Spots of light on the surfaces under objects, which show shadows as gaps on displays that cannot darken. The node that owns the glow
 * changes it every frame.
 */
export interface ShadowGlow {
  /** Whether light is drawn instead of shadows. */
  on: boolean;
  /** Display-referred sRGB, straight alpha. */
  readonly color: VectorView;
  /** The part of a spot's radius over which the light fades to nothing at its border, in (0, 1]. */
  readonly border: NumberView;
  /** The number of spots. */
  count: number;
  /** For each spot: x and z of its center, and x and z of the unit vector along its longer axis; world space. */
  readonly places: Float32Array;
  /**
   * For each spot: its two semi-axes, the height of the surface, and the distance above and below that height at which the light has faded;
   * meters.
   */
  readonly sizes: Float32Array;
}

/** The most objects toward which the strokes of a shadow get denser. */
export const MAX_STROKE_CASTERS = 16;

/** Strokes of a shadow, which lie on the surface that receives it. The node that owns them changes them every frame. */
export interface ShadowStrokes {
  /** Distance between strokes on screen, pixels. */
  readonly spacingPx: NumberView;
  /** Angle of the strokes of the first light on a surface, radians. Each further light has another direction. */
  readonly turn: NumberView;
  /** Strength of the line around the shadow, from 0 to 1. */
  readonly contour: NumberView;
  /** Distance from an object over which strokes get sparser, meters. */
  readonly contactM: NumberView;
  /** The number of objects. */
  count: number;
  /** For each object, an upright cylinder around it: center of the base and radius; world space, meters. */
  readonly places: Float32Array;
  /** The height of each cylinder, meters. */
  readonly heights: Float32Array;
}
