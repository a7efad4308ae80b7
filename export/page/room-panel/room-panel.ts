import type { SessionFrame } from '../../../nodes/kit/session.ts';
import type { ControlValues } from '../control-values.ts';
import { createMeasure, paintPanel, repaintArea, type Touch } from './paint-panel.ts';
import { createPanelDrawer, type PanelDrawer } from './panel-drawer.ts';
import { layOutPanel } from './panel-layout.ts';
import { createPanelPose } from './panel-pose.ts';
import { createPointing } from './pointing.ts';

/** The controls on a panel in the room, for sessions that hide the page. */
export interface RoomPanel {
  /** Applies input to the controls, before the program draws. Returns the frame for the program. */
  take(frame: SessionFrame): SessionFrame;
  /** Draws the panel, after the program has drawn the same frame. */
  draw(frame: SessionFrame): void;
  /** Places the panel again, because the reference space was reset. */
  reset(): void;
  /** Drops the GPU objects, which are lost with the context; the next frame creates them again. */
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

/**
 * Maximum width and height of the panel's image, pixels: a texture size that WebGL 2 guarantees. A larger panel is painted at a lower
 * resolution; its size in the room stays the same.
 */
const MOST_PX = 2048;

export function createRoomPanel({ gl, document, title, values }: RoomPanelOptions): RoomPanel {
  const canvas = document.createElement('canvas');
  // Parts of the image are read when a ray comes or goes.
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('The browser has no 2D canvas.');
  const layout = layOutPanel(title, values.controls, createMeasure(context));
  const scale = Math.min(1, MOST_PX / Math.max(layout.widthPx, layout.heightPx));
  canvas.width = Math.round(layout.widthPx * scale);
  canvas.height = Math.round(layout.heightPx * scale);
  context.scale(scale, scale);
  const pose = createPanelPose();
  const pointing = createPointing(layout, values);
  let drawer: PanelDrawer | null = null;
  /** Whether the whole image must be painted. */
  let stale = true;
  /** Parts come first, so that their indices are those of the layout. */
  const areas = [...layout.parts, ...layout.headings];
  /** Areas that have changed since the image was painted. A whole image takes milliseconds to upload, an area a tenth of one. */
  const changed = areas.map(() => false);
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
      for (const part of [before.part, before.held, pointer.part, pointer.held]) if (part >= 0) changed[part] = true;
      before.part = pointer.part;
      before.held = pointer.held;
    }
  };
  const upload = (drawer: PanelDrawer): void => {
    if (stale) {
      paintPanel(context, layout, values, touchOf);
      drawer.upload(canvas);
      stale = false;
      changed.fill(false);
      return;
    }
    for (let i = 0; i < areas.length; i++) {
      const area = areas[i];
      if (!area || !changed[i]) continue;
      const { pixels, x, y } = repaintArea(context, layout, values, touchOf, area, scale);
      drawer.uploadArea(pixels, x, y);
      changed[i] = false;
    }
  };
  const stop = values.listen((control) => {
    // A button does not show how often it was pressed.
    if (values.controls[control]?.kind === 'button') return;
    for (let i = 0; i < areas.length; i++) if (areas[i]?.control === control) changed[i] = true;
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
      upload(drawer);
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
