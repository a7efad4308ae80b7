import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { Session, SessionEvent, SessionFrame } from '../../nodes/kit/session.ts';
import type { Program } from '../program/program.ts';
import type { AssetSource } from '../runtime/assets/asset-source.ts';
import { createPlayer, type Player } from '../runtime/player.ts';
import type { CreateSceneBackend } from '../runtime/scene-backend.ts';
import type { RoomPanel } from './room-panel/room-panel.ts';

export interface MountOptions {
  readonly program: Program;
  readonly modules: Readonly<Record<string, NodeModule>>;
  readonly createScenes: CreateSceneBackend | null;
  readonly assets: AssetSource;
  /** Shows the controls in sessions that hide the page; null where there are none. */
  readonly createPanel: ((gl: WebGL2RenderingContext) => RoomPanel) | null;
  /** What is played first; made on the canvas's context. */
  readonly session: (gl: WebGL2RenderingContext) => Session;
  readonly onDiagnostics: (diagnostics: readonly Diagnostic[]) => void;
  readonly onSessionEvent: (event: SessionEvent, session: Session) => void;
  /** The GPU took the context away, or gave it back. */
  readonly onContext: (state: 'lost' | 'restored') => void;
}

export interface Mounted {
  readonly gl: WebGL2RenderingContext;
  readonly player: Player;
  /** Ends the current session and plays this one. Null plays none. */
  play(session: Session | null): Promise<void>;
  dispose(): Promise<void>;
}

/**
 * Plays a program on a canvas with the given session. Throws if the browser has no WebGL 2.
 * The canvas is transparent, so that the page's background shows behind it.
 */
export function mount(canvas: HTMLCanvasElement, options: MountOptions): Mounted {
  const gl = canvas.getContext('webgl2', {
    alpha: true,
    antialias: options.program.presentation.antialias,
    depth: true,
    stencil: false,
    powerPreference: 'high-performance',
  });
  if (!gl) throw new Error(NO_WEBGL);
  const player = createPlayer({ ...options, gl, canvas, seed: 1 });
  let playing: Session | null = null;
  let panel: RoomPanel | null = null;

  const lost = (event: Event) => {
    // Without this the browser never gives the context back.
    event.preventDefault();
    player.contextLost();
    panel?.contextLost();
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
    // Another session was set while the earlier one ended.
    if (playing !== session) return void session?.end();
    player.setSession(session);
    const shown = session?.hidesPage === true ? (options.createPanel?.(gl) ?? null) : null;
    panel = shown;
    const draw = (frame: SessionFrame) => {
      player.draw(shown?.take(frame) ?? frame);
      shown?.draw(frame);
    };
    session?.start(draw, (event) => {
      if (event.kind === 'reset') {
        player.reset();
        shown?.reset();
      }
      if (event.kind === 'ended') {
        shown?.dispose();
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
    dispose: async () => {
      await play(null);
      canvas.removeEventListener('webglcontextlost', lost);
      canvas.removeEventListener('webglcontextrestored', restored);
      player.dispose();
    },
  };
}

const NO_WEBGL = 'This browser has no WebGL 2. Open the page in a current Chrome, Edge, Firefox or Safari, with hardware acceleration on.';
