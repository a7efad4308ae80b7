import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Inspected } from '../../../export/runtime/inspected.ts';
import type { Player } from '../../../export/runtime/player.ts';
import { pickObject, placedObjects } from '../../../export/runtime/scenes/placed-objects.ts';
import type { SessionFrame } from '../../../nodes/kit/session.ts';
import type { FromPreview, PreviewGizmo, ToPreview } from '../../preview-protocol.ts';
import type { CaptureSource } from '../posters.ts';
import { createOverlay, type Overlay, type ViewBox } from './overlay.ts';
import { type Place, paramsOf, type ReadParam, readPlace } from './place.ts';

/** Shows the gizmo in the preview, and reports clicks on objects. */
export interface Gizmo {
  receive(message: Extract<ToPreview, { kind: 'gizmo' | 'picking' }>): void;
  afterFrame(player: Pick<Player, 'inspect'>, frame: SessionFrame, place: CaptureSource | null): void;
  dispose(): void;
}

const MODES = { move: 'translate', rotate: 'rotate', scale: 'scale' } as const;
const SNAP_M = 0.1;
const SNAP_RAD = Math.PI / 12;
const SNAP_FACTOR = 0.1;
/** Maximum movement of the pointer between press and release of a click. */
const CLICK_PX = 4;
/** A direction has no position, so its gizmo is shown at this distance in front of the viewer. */
const AHEAD_M = 1.5;

/** Matrix of the nodes after the gizmo target. Written and read within one call. */
const scratchMatrix = new Matrix4();

/**
 * A press that becomes a click if the pointer releases where it pressed. What it picks is decided by the frame after the press, before
 * its release can change the scene: what a tap places is not picked by that tap.
 */
interface Press {
  readonly pointer: number;
  /** Position, CSS pixels of the page. */
  readonly x: number;
  readonly y: number;
  /** Position in view UV, origin at the bottom left. */
  readonly u: number;
  readonly v: number;
  /** What is at this position; undefined before the frame that decides it. */
  picked?: ReturnType<typeof pickObject>;
  isClick: boolean;
}

interface Drag {
  readonly pointer: number;
  readonly from: Place;
  readonly gizmo: PreviewGizmo;
  readonly read: ReadParam;
}

/**
 * Creates the gizmo over the preview.
 *
 * @param wake Requests a frame, also while the preview is paused.
 */
export function createGizmo(parent: HTMLElement, send: (message: FromPreview) => void, wake: () => void): Gizmo {
  let gizmo: PreviewGizmo | null = null;
  let picking = false;
  let overlay: Overlay | null = null;
  let seen = false;
  let box: ViewBox | null = null;
  let drag: Drag | null = null;
  let drags = 0;
  let press: Press | null = null;
  let reading: ReadParam = () => null;

  const pointerOf = ({ clientX, clientY }: PointerEvent, button: number) => {
    const { left = 0, top = 0, width = 1, height = 1 } = box ?? {};
    return { x: (2 * (clientX - left)) / width - 1, y: 1 - (2 * (clientY - top)) / height, button } as unknown as PointerEvent;
  };
  const hover = (event: PointerEvent) => {
    if (!overlay || !seen || drag) return;
    const before = overlay.controls.axis;
    overlay.controls.pointerHover(pointerOf(event, 0));
    if (overlay.controls.axis === before) return;
    document.body.style.cursor = overlay.controls.axis === null ? '' : 'grab';
    overlay.draw();
  };
  const clearHover = () => {
    if (!overlay || drag || overlay.controls.axis === null) return;
    overlay.controls.axis = null;
    document.body.style.cursor = '';
    if (seen) overlay.draw();
  };
  /** Only events that leave the page have no related target. */
  const onOut = (event: PointerEvent) => {
    if (event.relatedTarget === null) clearHover();
  };
  const swallow = (event: Event) => {
    event.stopImmediatePropagation();
    event.preventDefault();
  };
  const endDrag = () => {
    const ended = drag;
    drag = null;
    document.body.style.cursor = '';
    if (overlay && ended) {
      overlay.controls.dragging = false;
      overlay.controls.axis = null;
      if (overlay.canvas.hasPointerCapture(ended.pointer)) overlay.canvas.releasePointerCapture(ended.pointer);
    }
    wake();
  };
  const cancel = () => {
    endDrag();
    send({ kind: 'gizmo', drag: drags, state: 'cancelled', values: {} });
  };
  const sendValues = (state: 'moved' | 'ended') => {
    if (!drag || !overlay) return;
    const { gizmo: held, read, from } = drag;
    send({ kind: 'gizmo', drag: drags, state, values: paramsOf(held.mode, held.handles, read, from, overlay.object) });
  };

  const onDown = (event: PointerEvent) => {
    if (event.button !== 0 || drag) return;
    hover(event);
    press = picking && box ? pressOf(event, box) : null;
    if (press) wake();
    if (overlay && seen && gizmo && overlay.controls.axis !== null) {
      overlay.controls.pointerDown(pointerOf(event, 0));
      overlay.canvas.setPointerCapture(event.pointerId);
      const { position, quaternion, scale } = overlay.object;
      const from = { position: position.clone(), quaternion: quaternion.clone(), scale: scale.clone() };
      drags++;
      drag = { pointer: event.pointerId, from, gizmo, read: freezeParams(gizmo, reading) };
      document.body.style.cursor = 'grabbing';
      event.stopImmediatePropagation();
    }
  };
  /** Prevents the default, so that the editor page keeps the focus. */
  const onMouseDown = (event: MouseEvent) => {
    if (drag) swallow(event);
  };
  const onMove = (event: PointerEvent) => {
    if (drag?.pointer !== event.pointerId) {
      if (event.buttons === 0) hover(event);
      return;
    }
    event.stopImmediatePropagation();
    if (!overlay) return;
    const snaps = drag.gizmo.snap !== (event.ctrlKey || event.metaKey);
    overlay.controls.translationSnap = snaps ? SNAP_M : null;
    overlay.controls.rotationSnap = snaps ? SNAP_RAD : null;
    overlay.controls.scaleSnap = snaps ? SNAP_FACTOR : null;
    overlay.controls.pointerMove(pointerOf(event, -1));
    overlay.draw();
    sendValues('moved');
  };
  const onUp = (event: PointerEvent) => {
    if (drag?.pointer === event.pointerId) {
      event.stopImmediatePropagation();
      sendValues('ended');
      endDrag();
    }
    if (press?.pointer !== event.pointerId) return;
    // Clicks on the gizmo count, too, because it covers small objects.
    press.isClick = Math.hypot(event.clientX - press.x, event.clientY - press.y) <= CLICK_PX;
    if (press.isClick) wake();
    else press = null;
  };
  const onCancel = (event: PointerEvent) => {
    if (press?.pointer === event.pointerId) press = null;
    if (drag?.pointer === event.pointerId) cancel();
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (!drag || event.key !== 'Escape') return;
    swallow(event);
    cancel();
  };
  const listeners = [
    ['pointerdown', onDown],
    ['mousedown', onMouseDown],
    ['pointermove', onMove],
    ['pointerout', onOut],
    ['pointerup', onUp],
    ['pointercancel', onCancel],
    ['keydown', onKeyDown],
  ] as const;
  // Listens in the capture phase, before the listeners of the walk and of taps.
  for (const [type, listener] of listeners) window.addEventListener(type, listener as EventListener, true);

  const show = (inspected: Inspected, frame: SessionFrame) => {
    const [view] = frame.views;
    const held = gizmo;
    if (!held || !view || !box) return false;
    reading = held.adds ? () => null : readerOf(inspected, held.node);
    overlay ??= createOverlay(parent);
    overlay.setView(view, box);
    const { controls, object } = overlay;
    if (!drag) {
      readPlace(held.handles, reading, object);
      if (placedObjects(inspected, held.node, held.chain, scratchMatrix)) overlay.parent.matrix.copy(scratchMatrix);
      if (isDirection(held)) object.position.copy(ahead(view.worldFromView)).applyMatrix4(scratchMatrix.invert());
      // The axis under the pointer is one of the last tool.
      if (controls.mode !== MODES[held.mode]) clearHover();
      controls.mode = MODES[held.mode];
      controls.space = held.space;
    }
    overlay.parent.updateMatrixWorld(true);
    return true;
  };

  return {
    receive: (message) => {
      if (message.kind === 'picking') picking = message.on;
      else {
        if (message.gizmo === null && drag) endDrag();
        gizmo = message.gizmo;
        wake();
      }
    },
    afterFrame: (player, frame, place) => {
      const inspected = place && player.inspect(null);
      box = place && boxOf(place.canvas, frame);
      if (press && inspected) {
        if (press.picked === undefined) press.picked = pickObject(inspected, 0, press.u, press.v);
        if (press.isClick) {
          if (press.picked) send({ kind: 'picked', chain: press.picked.way, phantom: press.picked.role === 'phantom' });
          press = null;
        }
      }
      seen = inspected ? show(inspected, frame) : false;
      if (seen) overlay?.draw();
      overlay?.setShown(seen && gizmo ? gizmo.mode : null);
    },
    dispose: () => {
      for (const [type, listener] of listeners) window.removeEventListener(type, listener as EventListener, true);
      overlay?.dispose();
    },
  };
}

/** The press at an event; null outside the view. */
function pressOf({ pointerId: pointer, clientX: x, clientY: y }: PointerEvent, box: ViewBox): Press | null {
  const [u, v] = [(x - box.left) / box.width, 1 - (y - box.top) / box.height];
  return u < 0 || u > 1 || v < 0 || v > 1 ? null : { pointer, x, y, u, v, isClick: false };
}

/** Reads the params once, at the start of a drag. Later values would follow the drag itself. */
function freezeParams({ handles }: PreviewGizmo, read: ReadParam): ReadParam {
  const values = new Map(Object.values(handles).map((param) => [param, read(param)]));
  return (param) => values.get(param) ?? null;
}

function readerOf({ program, slots }: Inspected, node: string): ReadParam {
  return (param) => {
    for (const operation of program.operations) {
      if (operation.node !== node || operation.kind === 'pass' || operation.kind === 'shadow-maps' || operation.kind === 'readback')
        continue;
      const slot = Object.hasOwn(operation.params, param) ? operation.params[param] : undefined;
      if (slot === undefined) continue;
      const offset = slots.offset(slot);
      const size = slots.slots[slot]?.type === 'vector3' ? 3 : 1;
      return [...slots.numbers.subarray(offset, offset + size)];
    }
    return null;
  };
}

function isDirection({ handles }: PreviewGizmo): boolean {
  return handles.position === undefined && (handles.azimuth !== undefined || handles.elevation !== undefined);
}

// Written and read within one call.
const scratchView = new Matrix4();
const scratchAhead = new Vector3();
const scratchTurn = new Quaternion();
const scratchScale = new Vector3();

function ahead(worldFromView: Float32Array): Vector3 {
  scratchView.fromArray(worldFromView).decompose(scratchAhead, scratchTurn, scratchScale);
  return scratchAhead.add(scratchScale.set(0, 0, -AHEAD_M).applyQuaternion(scratchTurn));
}

/** Rectangle of the first view on the page. */
export function boxOf(canvas: HTMLCanvasElement, { views, framebufferWidthPx, framebufferHeightPx }: SessionFrame): ViewBox | null {
  const viewport = views[0]?.viewport;
  if (!viewport || viewport.widthPx < 1 || framebufferWidthPx < 1) return null;
  const page = canvas.getBoundingClientRect();
  const [perX, perY] = [page.width / framebufferWidthPx, page.height / framebufferHeightPx];
  return {
    left: page.left + viewport.x * perX,
    top: page.top + (framebufferHeightPx - viewport.y - viewport.heightPx) * perY,
    width: viewport.widthPx * perX,
    height: viewport.heightPx * perY,
  };
}
