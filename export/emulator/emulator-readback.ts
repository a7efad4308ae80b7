import { P_SESSION } from 'iwer';
import { compositePixels, type Pixels, turnRows } from './display/composite.ts';
import type { Emulator } from './emulator.ts';
import { P_EMULATED } from './private.ts';
import type { EmulatedSession } from './session/emulated-session.ts';
import type { SessionWorld } from './session/grant-session.ts';
import { type Presentation, presentationOf } from './session/presentation.ts';
import { showPresentation } from './session/run-frame.ts';

/** Reads back images of the last frame. */
export function createReadback(world: SessionWorld): Pick<Emulator, 'readLayer' | 'readRoom' | 'readComposite' | 'counts'> {
  const presenting = (): { session: EmulatedSession; shown: Presentation } => {
    const shown = world.session && presentationOf(world.session);
    if (!world.session || !shown) throw new Error('No session with a layer is running.');
    return { session: world.session, shown };
  };
  const takeLayer = (): Pixels => {
    const { shown } = presenting();
    return turnRows(shown.read(), shown.widthPx, shown.heightPx);
  };
  const takeRoom = (): Pixels => {
    const { session, shown } = presenting();
    const { roomServices, eyes } = session[P_EMULATED];
    const { widthPx, heightPx } = shown;
    const rgba = new Uint8Array(widthPx * heightPx * 4);
    const { display } = world.settings;
    // With `display`, the canvas contains room and layer: draw the room alone, then restore the layer.
    if (display) roomServices.view.aimRoom(session[P_SESSION].mode === 'immersive-ar' ? eyes : []);
    roomServices.view.readPixels(rgba);
    if (display) showPresentation(session, shown);
    return turnRows(rgba, widthPx, heightPx);
  };
  return {
    readLayer: takeLayer,
    readRoom: takeRoom,
    readComposite: () => {
      const { session } = presenting();
      const blend = session[P_SESSION].mode === 'immersive-ar' ? world.profile.blend : 'opaque';
      return compositePixels(takeLayer(), takeRoom(), blend, world.settings.displayGain);
    },
    counts: () => {
      const { memory, programs } = world.roomServices().view.renderer.info;
      return { geometries: memory.geometries, textures: memory.textures, programs: programs?.length ?? 0 };
    },
  };
}
