import type { HitSource } from '../../kit/hit-test.ts';
import { createHit } from '../../kit/hit-test.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { SessionFrame } from '../../kit/session.ts';
import { type BoardLabel, boardOf } from './board.ts';
import type { definition } from './definition.ts';
import { createLabelContent } from './label-content.ts';
import { createLabelElement, type LabelElement } from './label-element.ts';
import { createLabelObjects } from './label-objects.ts';
import { createLabelPose } from './label-pose.ts';
import { createPageMatrices } from './page-matrices.ts';

/**
 * The sources that may hide a label, each asked alone: a ray that asks several gets the hit of the first, though another may be nearer. The
 * floor is left out: most sessions only assume it, and real things stand on it.
 */
const SOURCES: readonly (readonly HitSource[])[] = [['plane'], ['mesh'], ['depth'], ['voxels']];
/** A label is hidden only if it is at least this far behind a surface, so that noise of the depth does not hide a label on a surface. */
const BEHIND_M = 0.08;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { config, params, inputs, outputs } = ctx;
  const content = createLabelContent(ctx);
  const pose = createLabelPose(config.facing, config.sizeIn);
  const matrices = createPageMatrices();
  const objects = createLabelObjects(outputs.objects);
  const board = boardOf(ctx.session);
  const worldFromRay = new Float32Array(16);
  const hit = createHit();
  let element: LabelElement | null = null;
  let overlay: HTMLElement | null = null;
  /** Whether the room hid the label when it last checked. */
  let isBehind = false;
  /** The versions of the content that the element and the texture show. */
  let elementVersion = -1;
  let textureVersion = -1;

  const label: BoardLabel = {
    overlap: config.overlap,
    looks: config.fade,
    wants: false,
    distanceM: 0,
    atMost: 1,
    box: { left: 0, right: 0, bottom: 0, top: 0 },
    shown: false,
    moved: 0,
    mayLook: false,
    unseenFrames: Number.POSITIVE_INFINITY,
    prepare: (frame) => {
      label.atMost = params.atMost.value;
      label.wants = inputs.pose?.valid === true && frame.viewCount > 0 && content.update();
      if (!label.wants || !inputs.pose) return;
      const { layout } = content;
      const size = config.sizeIn === 'room' ? params.sizeM.value : params.sizeOfView.value;
      label.wants = pose.set(inputs.pose.worldFromPose, frame, layout.widthPx, layout.heightPx, size, params.liftM.value, label.box);
      label.distanceM = pose.distanceM;
    },
  };
  board.add(label);

  /** Creates or removes the element and returns it: sessions differ in whether the page is visible. */
  function findElement(frame: SessionFrame): LabelElement | null {
    const next = config.where === 'page' && frame.viewCount === 1 ? (ctx.session.overlay ?? null) : null;
    if (next !== overlay) {
      element?.dispose();
      element = next && createLabelElement(next);
      overlay = next;
      elementVersion = -1;
    }
    return element;
  }

  function opacity(): number {
    if (!config.fade) return 1;
    // In renders each frame depends on itself alone.
    if (label.mayLook || ctx.clock.held) {
      pose.writeRay(worldFromRay);
      isBehind = false;
      for (let i = 0; i < SOURCES.length && !isBehind; i++) {
        isBehind = ctx.session.castRay(worldFromRay, hit, SOURCES[i]) && hit.distanceM < pose.distanceM - BEHIND_M;
      }
    }
    return isBehind ? params.faded.value : 1;
  }

  function showElement(shownIn: LabelElement, frame: SessionFrame): void {
    if (elementVersion !== content.version) shownIn.setContent(content.layout, content.icon, content.colors, config.selectable);
    elementVersion = content.version;
    const alpha = opacity();
    matrices.set(frame, shownIn);
    shownIn.place(matrices.label(pose), alpha);
    shownIn.placeLeader(params.leader.value ? matrices.leader(pose) : null, alpha);
  }

  function showObjects(): void {
    if (textureVersion !== content.version) objects.paint(content);
    textureVersion = content.version;
    objects.show(pose, opacity(), params.leader.value, params.color.value);
  }

  return {
    update: (frame) => {
      board.arrange(label, frame);
      const shownIn = findElement(frame);
      if (label.shown) pose.moveUp(label.moved);
      if (!label.shown || !shownIn) element?.hide();
      if (!label.shown || shownIn) objects.hide();
      if (!label.shown) return;
      if (shownIn) showElement(shownIn, frame);
      else showObjects();
    },
    dispose: () => {
      board.remove(label);
      element?.dispose();
      objects.dispose();
    },
  };
}
