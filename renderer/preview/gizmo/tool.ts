import type { Inspected } from '../../../export/runtime/inspected.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import type { GizmoMode, PreviewGizmo } from '../../preview-protocol.ts';
import type { ReadParam } from './place.ts';

/** Rectangle of a view on the page, in CSS pixels from the top left. */
export interface ViewBox {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** What a gizmo is shown for in a frame. */
export interface GizmoView {
  readonly gizmo: PreviewGizmo;
  readonly inspected: Inspected;
  readonly view: ViewFrame;
  readonly box: ViewBox;
  readonly read: ReadParam;
}

export type GizmoValues = Readonly<Record<string, number | readonly number[]>>;

/** A kind of gizmo: what is drawn over the preview, and what its parts do. Points are CSS pixels of the page. */
export interface GizmoTool {
  /** Takes the pointer events of a drag. */
  readonly canvas: Element;
  /** Whether a part is under the pointer or dragged. */
  isActive(): boolean;
  /** Finds the part under the pointer. Returns whether it is another one. */
  hover(x: number, y: number): boolean;
  /** Clears the part under the pointer. */
  leave(): void;
  /** Begins to drag the part under the pointer, for params as they are now. */
  begin(x: number, y: number): void;
  move(x: number, y: number, snaps: boolean): void;
  /** Values of the params after the last move of the drag. */
  values(): GizmoValues;
  end(): void;
  /** Follows a frame, and sets the node as a data attribute, so that tests can wait for it. Returns whether the gizmo can be shown. */
  follow(view: GizmoView): boolean;
  draw(): void;
  /** Sets `mode` as a data attribute, so that tests can wait for it; null hides the gizmo. */
  setShown(mode: GizmoMode | null): void;
  dispose(): void;
}

/** Reads the params once, at the start of a drag. Later values would follow the drag itself. */
export function freezeParams({ handles }: PreviewGizmo, read: ReadParam): ReadParam {
  const values = new Map(Object.values(handles).map((param) => [param, read(param)]));
  return (param) => values.get(param) ?? null;
}
