import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { Session, SessionEvent, SessionFrame } from '../../nodes/kit/session.ts';
import type { Program } from '../program/program.ts';
import type { AssetSource } from '../runtime/assets/asset-source.ts';
import { createPlayer, type Player } from '../runtime/player.ts';
import type { CreateSceneBackend } from '../runtime/scene-backend.ts';
import type { CreateSpatial } from '../runtime/spatial/spatial.ts';
import type { RoomPanel } from './room-panel/room-panel.ts';

export interface MountOptions {
  readonly program: Program;
  readonly modules: Readonly<Record<string, NodeModule>>;
  readonly createScenes: CreateSceneBackend | null;
  /** Creates hit tests and anchors; null if the program needs neither. */
  readonly createSpatial: CreateSpatial | null;
  /** The element that contains labels; null if the program has none. */
  readonly overlay: HTMLElement | null;
  readonly assets: AssetSource;
  /** Creates the panel for sessions that hide the page. Returns null without controls. */
  readonly createPanel: (gl: WebGL2RenderingContext) => RoomPanel | null;
  /** What may draw instead of the program for a time, such as the step that takes a panorama; null for none. */
  readonly interlude: Interlude | null;
  /** Creates the first session for the context of the canvas. */
  readonly session: (gl: WebGL2RenderingContext) => Session;
  readonly onDiagnostics: (diagnostics: readonly Diagnostic[]) => void;
  readonly onSessionEvent: (event: SessionEvent, session: Session) => void;
  /** Called if the WebGL context is lost or restored. */
  readonly onContext: (state: 'lost' | 'restored') => void;
}

/** Gets each frame before the program, and draws instead of it while `covers` is true. */
export interface Interlude {
  readonly covers: boolean;
  frame(frame: SessionFrame): void;
  /** Drops the GPU objects, which are lost with the context. */
  contextLost(): void;
}

export interface Mounted {
  readonly gl: WebGL2RenderingContext;
  readonly player: Player;
  /** Ends the current session and starts another one; null starts none. */
  play(session: Session | null): Promise<void>;
  /** Shows a panel in the room instead of that with the controls until the session ends, and disposes it then; null removes it. */
  cover(panel: RoomPanel | null): void;
  dispose(): Promise<void>;
}

/**
 * Plays a program on a canvas with the given session. The canvas is transparent, so the page's background is visible behind it.
 *
 * @throws Error if the browser has no WebGL 2.
 */
export function mount(canvas: HTMLCanvasElement, options: MountOptions): Mounted {
  const { antialias, screenDepth } = options.program.presentation;
  const gl = canvas.getContext('webgl2', {
    alpha: true,
    antialias,
    depth: screenDepth !== 'none',
    stencil: false,
    powerPreference: 'high-performance',
  });
  if (!gl) throw new Error(NO_WEBGL);
  const player = createPlayer({ ...options, gl, canvas, seed: 1 });
  let playing: Session | null = null;
  let panel: RoomPanel | null = null;
  let covering: RoomPanel | null = null;

  const cover = (next: RoomPanel | null) => {
    covering?.dispose();
    covering = next;
  };
  const lost = (event: Event) => {
    // Without it, the browser does not restore the context.
    event.preventDefault();
    player.contextLost();
    panel?.contextLost();
    covering?.contextLost();
    options.interlude?.contextLost();
    options.onContext('lost');
  };
  const restored = () => {
    void player.restore().then(() => options.onContext('restored'));
  };
  canvas.addEventListener('webglcontextlost', lost);
  canvas.addEventListener('webglcontextrestored', restored);

  const play = async (session: Session | null) => {
    const before = playing;
    playing = session;
    await before?.end();
    // Another session was set while this one was waiting for its predecessor to end.
    if (playing !== session) return void session?.end();
    player.setSession(session);
    const shown = session?.hidesPage === true ? options.createPanel(gl) : null;
    panel = shown;
    const draw = (frame: SessionFrame) => {
      const top = covering ?? shown;
      const passed = top?.take(frame) ?? frame;
      options.interlude?.frame(passed);
      // Headsets need every frame, and a canvas that others draw to does not keep the image.
      const keepsImage = frame.framebuffer === null && top === null && options.interlude === null;
      if (keepsImage) player.drawChanges(passed);
      else if (options.interlude?.covers !== true) player.draw(passed);
      // A press may have removed the covering panel in this frame.
      (covering ?? shown)?.draw(frame);
    };
    session?.start(draw, (event) => {
      if (event.kind === 'reset') player.reset(event.cause);
      if (event.kind === 'reset' || event.kind === 'recentered') for (const each of [shown, covering]) each?.reset();
      if (event.kind === 'ended') {
        shown?.dispose();
        cover(null);
        if (playing === session) playing = null;
        if (panel === shown) panel = null;
      }
      options.onSessionEvent(event, session);
    });
  };

  void play(options.session(gl));
  return {
    gl,
    player,
    play,
    cover,
    dispose: async () => {
      await play(null);
      canvas.removeEventListener('webglcontextlost', lost);
      canvas.removeEventListener('webglcontextrestored', restored);
      player.dispose();
    },
  };
}

const NO_WEBGL = 'This browser has no WebGL 2. Open the page in a current Chrome, Edge, Firefox or Safari, with hardware acceleration on.';
