import { Matrix4, Vector3 } from 'three';
import type { PhysicsBody, PhysicsJoint } from '../../../nodes/kit/physics.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import { castOnBody } from '../../../nodes/kit/three/cast-body.ts';
import { createDragJoint, type DragSpring } from '../../../nodes/kit/three/drag-joint.ts';
import type { ViewBox } from '../gizmo/tool.ts';

/** Drags bodies by the pointer while their shapes are shown. A body that is let go keeps its velocity. */
export interface BodyDrag {
  /** The body that was pressed last; null after a press beside all bodies. */
  readonly selected: PhysicsBody | null;
  /** Tells what can be dragged in this frame; null without a view. */
  see(bodies: readonly PhysicsBody[], view: Pick<ViewFrame, 'clipFromView' | 'worldFromView'> | null, box: ViewBox | null): void;
  dispose(): void;
}

const FAR_M = 50;
const SPRING: DragSpring = { frequencyHz: 8, maxForceN: 0 };
const NO_TURN = new Matrix4().elements;
/** Maximum movement of the pointer between press and release of a click. */
const CLICK_PX = 4;

interface Held {
  readonly pointer: number;
  readonly body: PhysicsBody;
  readonly joint: PhysicsJoint;
  /** Distance of the held point from the eye, along the axis of the view. */
  readonly depthM: number;
  readonly x: number;
  readonly y: number;
}

/** @param onClick Called with the node of a body that is clicked. */
export function createBodyDrag(onClick: (node: string) => void): BodyDrag {
  let seen: readonly PhysicsBody[] = [];
  let box: ViewBox | null = null;
  let held: Held | null = null;
  let selected: PhysicsBody | null = null;
  const worldFromClip = new Matrix4();
  const worldFromView = new Matrix4();
  const eye = new Vector3();
  const ahead = new Vector3();
  const direction = new Vector3();

  /** Writes the ray of a pointer to `eye` and `direction`. */
  function aim({ clientX, clientY }: PointerEvent): void {
    const { left = 0, top = 0, width = 1, height = 1 } = box ?? {};
    eye.setFromMatrixPosition(worldFromView);
    ahead.setFromMatrixColumn(worldFromView, 2).negate();
    direction
      .set((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height, 0.5)
      .applyMatrix4(worldFromClip)
      .sub(eye)
      .normalize();
  }
  const onDown = (event: PointerEvent): void => {
    if (event.button !== 0 || held || !box || seen.length === 0) return;
    aim(event);
    let nearestM = FAR_M;
    let body: PhysicsBody | null = null;
    for (const each of seen) {
      const distanceM = each.world && each.description.mode === 'dynamic' ? castOnBody(each, eye, direction) : FAR_M;
      if (distanceM >= nearestM) continue;
      nearestM = distanceM;
      body = each;
    }
    selected = body;
    if (!body) return;
    event.stopImmediatePropagation();
    const point = eye.clone().addScaledVector(direction, nearestM);
    const joint = createDragJoint('preview', body, point, NO_TURN, SPRING);
    body.joints.push(joint);
    held = { pointer: event.pointerId, body, joint, depthM: nearestM * direction.dot(ahead), x: event.clientX, y: event.clientY };
  };
  const onMove = (event: PointerEvent): void => {
    if (held?.pointer !== event.pointerId) return;
    event.stopImmediatePropagation();
    aim(event);
    direction.multiplyScalar(held.depthM / direction.dot(ahead)).add(eye);
    held.joint.worldFromTarget.set(direction.toArray(), 12);
  };
  const release = (): void => {
    const index = held?.body.joints.indexOf(held.joint) ?? -1;
    if (index >= 0) held?.body.joints.splice(index, 1);
    held = null;
  };
  const onUp = (event: PointerEvent): void => {
    if (held?.pointer !== event.pointerId) return;
    event.stopImmediatePropagation();
    const isClick = event.type === 'pointerup' && Math.hypot(event.clientX - held.x, event.clientY - held.y) <= CLICK_PX;
    // Keys of bodies begin with their nodes.
    if (isClick) onClick(held.body.key.slice(0, held.body.key.indexOf('/')));
    release();
  };
  const listeners = [
    ['pointerdown', onDown],
    ['pointermove', onMove],
    ['pointerup', onUp],
    ['pointercancel', onUp],
  ] as const;
  // In the capture phase, before the listeners of the walk and of taps; those of the gizmo were added before.
  for (const [type, listener] of listeners) window.addEventListener(type, listener, true);

  return {
    get selected() {
      return selected;
    },
    see: (bodies, view, at) => {
      seen = bodies;
      box = at;
      if (!view || bodies.length === 0) {
        release();
        return;
      }
      worldFromView.fromArray(view.worldFromView);
      worldFromClip.fromArray(view.clipFromView).invert().premultiply(worldFromView);
    },
    dispose: () => {
      for (const [type, listener] of listeners) window.removeEventListener(type, listener, true);
      release();
    },
  };
}
