import { Matrix4, Quaternion, Vector3 } from 'three';
import { firstInput, placedObjects, poseInto } from '../../../export/runtime/scenes/placed-objects.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import type { PreviewGizmo } from '../../preview-protocol.ts';
import { createOverlay } from './overlay.ts';
import { type Place, paramsOf, type ReadParam, readPlace } from './place.ts';
import { freezeParams, type GizmoTool, type ViewBox } from './tool.ts';

const MODES = { move: 'translate', rotate: 'rotate', scale: 'scale' } as const;
const SNAP_M = 0.1;
const SNAP_RAD = Math.PI / 12;
const SNAP_FACTOR = 0.1;
/** A direction has no position, so its gizmo is shown at this distance in front of the viewer. */
const AHEAD_M = 1.5;
/** The gizmo of a radius stays at its side of the ring while it is in this part of the view. */
const IN_VIEW = 0.9;

// Written and read within one call.
const scratchMatrix = new Matrix4();
const scratchView = new Matrix4();
const scratchPoint = new Vector3();
const scratchTurn = new Quaternion();
const scratchScale = new Vector3();

interface Drag {
  readonly gizmo: PreviewGizmo;
  readonly from: Place;
  readonly read: ReadParam;
}

/** The gizmo of what has a place in the room: arrows, rings and boxes. */
export function createSpaceTool(parentElement: HTMLElement): GizmoTool {
  const overlay = createOverlay(parentElement);
  const { controls, object, parent } = overlay;
  let box: ViewBox = { left: 0, top: 0, width: 1, height: 1 };
  let gizmo: PreviewGizmo | null = null;
  let reading: ReadParam = () => null;
  let drag: Drag | null = null;
  let side = 0;

  const pointerAt = (x: number, y: number, button: number) =>
    ({ x: (2 * (x - box.left)) / box.width - 1, y: 1 - (2 * (y - box.top)) / box.height, button }) as unknown as PointerEvent;

  /** Follows the copies: the gizmo stands where the copied object would be if it were moved by the param alone. */
  const followCopies = ({ mode, handles }: PreviewGizmo, copied: Matrix4 | undefined, view: ViewFrame) => {
    if (copied) parent.matrix.multiply(scratchMatrix.makeTranslation(scratchPoint.setFromMatrixPosition(copied)));
    if (mode === 'move') object.quaternion.identity();
    if (handles.radius === undefined) return;
    // A ring may be around the viewer: of its four sides, one that is seen.
    const offCenter = (turns: number) =>
      distanceFromCenter(
        scratchPoint
          .copy(object.position)
          .applyAxisAngle(UP, (turns * Math.PI) / 2)
          .applyMatrix4(parent.matrix),
        view,
      );
    if (offCenter(side) > IN_VIEW) side = [0, 1, 2, 3].reduce((best, turns) => (offCenter(turns) < offCenter(best) ? turns : best));
    parent.matrix.multiply(scratchMatrix.makeRotationY((side * Math.PI) / 2));
  };

  return {
    canvas: overlay.canvas,
    isActive: () => controls.axis !== null,
    hover: (x, y) => {
      const before = controls.axis;
      controls.pointerHover(pointerAt(x, y, 0));
      return controls.axis !== before;
    },
    leave: () => {
      controls.axis = null;
    },
    begin: (x, y) => {
      if (!gizmo) return;
      controls.pointerDown(pointerAt(x, y, 0));
      const from = { position: object.position.clone(), quaternion: object.quaternion.clone(), scale: object.scale.clone() };
      drag = { gizmo, from, read: freezeParams(gizmo, reading) };
    },
    move: (x, y, snaps) => {
      controls.translationSnap = snaps ? SNAP_M : null;
      controls.rotationSnap = snaps ? SNAP_RAD : null;
      controls.scaleSnap = snaps ? SNAP_FACTOR : null;
      controls.pointerMove(pointerAt(x, y, -1));
    },
    values: () => (drag ? paramsOf(drag.gizmo.mode, drag.gizmo.handles, drag.read, drag.from, object) : {}),
    end: () => {
      drag = null;
      controls.dragging = false;
      controls.axis = null;
    },
    follow: ({ gizmo: held, inspected, view, box: at, read }) => {
      gizmo = held;
      overlay.canvas.dataset.node = held.node;
      reading = held.adds ? () => null : read;
      box = at;
      overlay.setView(view, at);
      if (!drag) {
        readPlace(held.handles, reading, object);
        if (placedObjects(inspected, held.node, held.chain, scratchMatrix)) parent.matrix.copy(scratchMatrix);
        const pose = poseInto(inspected, held.node);
        if (pose?.valid === false) return false;
        if (pose) parent.matrix.fromArray(pose.worldFromPose);
        if (isDirection(held)) object.position.copy(ahead(view.worldFromView)).applyMatrix4(scratchMatrix.invert());
        const arranges = isArrangement(held);
        if (arranges) followCopies(held, firstInput(inspected, held.node)?.worldFromObject, view);
        controls.mode = MODES[held.mode];
        controls.space = arranges ? 'local' : held.space;
        controls.showX = held.axes.includes('x');
        controls.showY = held.axes.includes('y');
        controls.showZ = held.axes.includes('z');
      }
      parent.updateMatrixWorld(true);
      return true;
    },
    draw: overlay.draw,
    setShown: overlay.setShown,
    dispose: overlay.dispose,
  };
}

const UP = new Vector3(0, 1, 0);

/** Whether the drag arranges copies: along and about the axes of their node. */
function isArrangement({ mode, handles }: PreviewGizmo): boolean {
  if (mode === 'move') return handles.position === undefined && (handles.step !== undefined || handles.radius !== undefined);
  return mode === 'rotate' && handles.rotation === undefined && handles.turn !== undefined;
}

function isDirection({ handles }: PreviewGizmo): boolean {
  return handles.position === undefined && (handles.azimuth !== undefined || handles.elevation !== undefined);
}

function ahead(worldFromView: Float32Array): Vector3 {
  scratchView.fromArray(worldFromView).decompose(scratchPoint, scratchTurn, scratchScale);
  return scratchPoint.add(scratchScale.set(0, 0, -AHEAD_M).applyQuaternion(scratchTurn));
}

/** How far a point of the room is from the center of a view: 1 at its edges, infinite behind the viewer. */
function distanceFromCenter(point: Vector3, { worldFromView, clipFromView }: ViewFrame): number {
  point.applyMatrix4(scratchView.fromArray(worldFromView).invert());
  if (point.z >= 0) return Number.POSITIVE_INFINITY;
  point.applyMatrix4(scratchView.fromArray(clipFromView));
  return Math.max(Math.abs(point.x), Math.abs(point.y));
}
