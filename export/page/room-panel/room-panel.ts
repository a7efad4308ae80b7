import type { SessionFrame } from '../../../nodes/kit/session.ts';
import type { ControlValues } from '../control-values.ts';
import { createMeasure, paintPanel, type Touch } from './paint-panel.ts';
import { createPanelDrawer, type PanelDrawer } from './panel-drawer.ts';
import { layOutPanel } from './panel-layout.ts';
import { createPanelPose } from './panel-pose.ts';
import { createPointing } from './pointing.ts';

/** The controls on a panel in the room, for one session that hides the page. */
export interface RoomPanel {
  /** Before the program draws: lets hands and taps set the controls. Returns the frame as the program is to see it. */
  take(frame: SessionFrame): SessionFrame;
  /** After the program has drawn the same frame. */
  draw(frame: SessionFrame): void;
  /** Places are void: it stands anew where the viewer is. */
  reset(): void;
  /** Its GPU objects are lost. The next frame creates them again. */
  contextLost(): void;
  dispose(): void;
}

export interface RoomPanelOptions {
  readonly gl: WebGL2RenderingContext;
  readonly document: Document;
  readonly title: string;
  readonly values: ControlValues;
}

export type CreateRoomPanel = (options: RoomPanelOptions) => RoomPanel;

/** Every WebGL 2 has textures of 2048 pixels; more controls than fit at full size are painted smaller, not placed smaller. */
const MOST_PX = 2048;

export function createRoomPanel({ gl, document, title, values }: RoomPanelOptions): RoomPanel {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  if (!context) throw new Error('The browser has no 2D canvas.');
  const layout = layOutPanel(title, values.controls, createMeasure(context));
  const scale = Math.min(1, MOST_PX / Math.max(layout.widthPx, layout.heightPx));
  canvas.width = Math.round(layout.widthPx * scale);
  canvas.height = Math.round(layout.heightPx * scale);
  context.scale(canvas.width / layout.widthPx, canvas.height / layout.heightPx);
  const pose = createPanelPose();
  const pointing = createPointing(layout, values);
  let drawer: PanelDrawer | null = null;
  /** The picture is not what it should be. */
  let stale = true;
  const painted = pointing.pointers.map(() => ({ part: -1, held: -1 }));
  const touchOf = (part: number): Touch => {
    if (painted.some(({ held }) => held === part)) return 'held';
    return painted.some((touch) => touch.part === part) ? 'hover' : 'none';
  };
  const noteTouches = (): void => {
    for (let i = 0; i < painted.length; i++) {
      const pointer = pointing.pointers[i];
      const before = painted[i];
      if (!pointer || !before || (before.part === pointer.part && before.held === pointer.held)) continue;
      before.part = pointer.part;
      before.held = pointer.held;
      stale = true;
    }
  };
  const stop = values.listen(() => {
    stale = true;
  });
  return {
    take: (frame) => {
      pose.update(frame, pointing.isHeld);
      const passed = pointing.take(frame, pose.worldFromPanel);
      noteTouches();
      return passed;
    },
    draw: (frame) => {
      if (!drawer) {
        drawer = createPanelDrawer(gl, layout, canvas.width, canvas.height);
        stale = true;
      }
      if (stale) {
        paintPanel(context, layout, values, touchOf);
        drawer.upload(canvas);
        stale = false;
      }
      drawer.draw(frame, pose.worldFromPanel, pointing.pointers);
    },
    reset: pose.reset,
    contextLost: () => {
      drawer = null;
    },
    dispose: () => {
      stop();
      drawer?.dispose();
      drawer = null;
    },
  };
}
