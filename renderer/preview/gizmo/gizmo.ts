import type { Inspected } from '../../../export/runtime/inspected.ts';
import type { Player } from '../../../export/runtime/player.ts';
import { pickObject } from '../../../export/runtime/scenes/placed-objects.ts';
import { isImageHandle } from '../../../nodes/kit/handles.ts';
import type { SessionFrame } from '../../../nodes/kit/session.ts';
import { dragKeysOf } from '../../drag-keys.ts';
import type { FromPreview, PreviewGizmo, ToPreview } from '../../preview-protocol.ts';
import type { CaptureSource } from '../posters.ts';
import { createFineDrag, type FineDrag } from './fine-drag.ts';
import { createImageTool } from './image-tool.ts';
import type { ReadParam } from './place.ts';
import { createSpaceTool } from './space-tool.ts';
import type { GizmoTool, ViewBox } from './tool.ts';

/** Shows the gizmo in the preview, and reports clicks on objects. */
export interface Gizmo {
  receive(message: Extract<ToPreview, { kind: 'gizmo' | 'picking' }>): void;
  afterFrame(player: Pick<Player, 'inspect'>, frame: SessionFrame, place: CaptureSource | null): void;
  dispose(): void;
}

/** Maximum movement of the pointer between press and release of a click. */
const CLICK_PX = 4;

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

/**
 * Creates the gizmo over the preview.
 *
 * @param wake Requests a frame, also while the preview is paused.
 */
export function createGizmo(parent: HTMLElement, send: (message: FromPreview) => void, wake: () => void): Gizmo {
  let gizmo: PreviewGizmo | null = null;
  let picking = false;
  const tools: { space: GizmoTool | null; image: GizmoTool | null } = { space: null, image: null };
  /** The one that is shown, or was last. */
  let tool: GizmoTool | null = null;
  let seen = false;
  let box: ViewBox | null = null;
  /** The pointer of the drag. */
  let drag: number | null = null;
  let drags = 0;
  let followed: FineDrag | null = null;
  let press: Press | null = null;

  const hover = ({ clientX, clientY }: PointerEvent) => {
    if (!tool || !seen || drag !== null || !tool.hover(clientX, clientY)) return;
    document.body.style.cursor = tool.isActive() ? 'grab' : '';
    tool.draw();
  };
  const clearHover = () => {
    if (!tool || drag !== null || !tool.isActive()) return;
    tool.leave();
    document.body.style.cursor = '';
    if (seen) tool.draw();
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
    if (tool && ended !== null) {
      tool.end();
      if (tool.canvas.hasPointerCapture(ended)) tool.canvas.releasePointerCapture(ended);
    }
    wake();
  };
  const cancel = () => {
    endDrag();
    send({ kind: 'gizmo', drag: drags, state: 'cancelled', values: {} });
  };
  const sendValues = (state: 'moved' | 'ended') => {
    if (tool) send({ kind: 'gizmo', drag: drags, state, values: tool.values() });
  };

  const onDown = (event: PointerEvent) => {
    if (event.button !== 0 || drag !== null) return;
    hover(event);
    press = picking && box ? pressOf(event, box) : null;
    if (press) wake();
    if (tool && seen && gizmo && tool.isActive()) {
      tool.begin(event.clientX, event.clientY);
      followed = createFineDrag({ x: event.clientX, y: event.clientY });
      tool.canvas.setPointerCapture(event.pointerId);
      drags++;
      drag = event.pointerId;
      document.body.style.cursor = 'grabbing';
      event.stopImmediatePropagation();
      // Parts in the image do not cover one object more than others.
      if (tool === tools.image) press = null;
    }
  };
  /** Prevents the default, so that the editor page keeps the focus. */
  const onMouseDown = (event: MouseEvent) => {
    if (drag !== null) swallow(event);
  };
  const onMove = (event: PointerEvent) => {
    if (drag !== event.pointerId) {
      if (event.buttons === 0) hover(event);
      return;
    }
    event.stopImmediatePropagation();
    if (!tool || !gizmo || !followed) return;
    const { fine, snap } = dragKeysOf(event);
    const { x, y } = followed.move({ x: event.clientX, y: event.clientY }, fine);
    tool.move(x, y, gizmo.snap !== snap);
    tool.draw();
    sendValues('moved');
  };
  const onUp = (event: PointerEvent) => {
    if (drag === event.pointerId) {
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
    if (drag === event.pointerId) cancel();
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (drag === null || event.key !== 'Escape') return;
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

  const toolFor = ({ handles }: PreviewGizmo): GizmoTool => {
    const isImage = Object.keys(handles).some(isImageHandle);
    const other = isImage ? tools.space : tools.image;
    other?.setShown(null);
    if (isImage) {
      tools.image ??= createImageTool(parent);
      return tools.image;
    }
    tools.space ??= createSpaceTool(parent);
    return tools.space;
  };
  const show = (inspected: Inspected, frame: SessionFrame) => {
    const [view] = frame.views;
    if (!gizmo || !view || !box) return false;
    if (drag === null) tool = toolFor(gizmo);
    if (!tool) return false;
    return tool.follow({ gizmo, inspected, view, box, read: readerOf(inspected, gizmo.node) });
  };

  return {
    receive: (message) => {
      if (message.kind === 'picking') picking = message.on;
      else {
        if (message.gizmo === null && drag !== null) endDrag();
        // The part under the pointer is one of the last gizmo.
        if (message.gizmo?.node !== gizmo?.node || message.gizmo?.mode !== gizmo?.mode) clearHover();
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
      if (seen) tool?.draw();
      tool?.setShown(seen && gizmo ? gizmo.mode : null);
    },
    dispose: () => {
      for (const [type, listener] of listeners) window.removeEventListener(type, listener as EventListener, true);
      tools.space?.dispose();
      tools.image?.dispose();
    },
  };
}

/** The press at an event; null outside the view. */
function pressOf({ pointerId: pointer, clientX: x, clientY: y }: PointerEvent, box: ViewBox): Press | null {
  const [u, v] = [(x - box.left) / box.width, 1 - (y - box.top) / box.height];
  return u < 0 || u > 1 || v < 0 || v > 1 ? null : { pointer, x, y, u, v, isClick: false };
}

function readerOf({ program, slots }: Inspected, node: string): ReadParam {
  const valuesAt = (slot: number) => [...slots.numbers.subarray(slots.offset(slot), slots.offset(slot) + slots.size(slot))];
  return (param) => {
    for (const operation of program.operations) {
      if (operation.node !== node || operation.kind === 'pass' || operation.kind === 'shadow-maps' || operation.kind === 'readback')
        continue;
      const slot = Object.hasOwn(operation.params, param) ? operation.params[param] : undefined;
      if (slot !== undefined) return valuesAt(slot);
    }
    // Passes have no params, but uniforms.
    const slot = slots.find(`${node}.${param}`);
    return slot === undefined ? null : valuesAt(slot);
  };
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
