import type { Session } from '../../../nodes/kit/session.ts';
import type { Presentation } from '../../program/program-presentation.ts';
import { clearRectangle } from '../gl/clear.ts';
import { COPY_SAMPLER, COPY_UV } from '../gl/copy-shader.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { PlayState } from '../play-state.ts';

/** The properties of a session that the player needs. */
export type SessionTraits = Pick<Session, 'world' | 'blend' | 'hidesPage'>;

/** Draws what is behind all layers of a view. */
export interface Background {
  /** Clears the view's part of the screen, including depth, and draws the background. */
  draw(state: PlayState, session: SessionTraits | null): void;
}

/**
 * Creates the background: a color; or the camera image, if the session provides the world as one; else transparent, so that the device
 * shows the world or the page its own background.
 */
export function createBackground(
  gl: WebGL2RenderingContext,
  drawer: PassDrawer,
  copy: GlProgram,
  background: Presentation['background'],
): Background {
  const [r, g, b, a] = background === 'world' ? [0, 0, 0, 0] : background;
  const premultiplied = new Float32Array([r * a, g * a, b * a, a]);
  return {
    draw: (state, session) => {
      const { view } = state;
      if (!view) return;
      const { x, y, widthPx, heightPx } = view.viewport;
      clearRectangle(gl, state.frame.framebuffer, x, y, widthPx, heightPx, premultiplied);
      const image = background === 'world' && session?.world === 'image' ? view.cameraImage : null;
      const location = copy.state === 'linked' ? copy.uniform(COPY_SAMPLER) : null;
      state.screenIsEmpty = a === 0;
      if (!image || !location) return;
      state.screenIsEmpty = false;
      drawer.begin(state.frame.framebuffer, x, y, widthPx, heightPx, 'replace');
      drawer.use(copy);
      drawer.texture(0, location, image.texture, 'linear');
      gl.uniformMatrix3fv(copy.uniform(COPY_UV), false, image.uvFromViewUv);
      drawer.draw();
      drawer.end();
    },
  };
}
