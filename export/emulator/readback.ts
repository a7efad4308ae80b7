import { P_SESSION } from 'iwer';
import { compositePixels, type Pixels, turnRows } from './display/composite.ts';
import type { Emulator } from './emulator.ts';
import { P_EMULATED } from './private.ts';
import type { EmulatedSession } from './session/emulated-session.ts';
import { currentLayer, readLayer, showLayer } from './session/run-frame.ts';
import type { World } from './world.ts';

/** Pictures of the last frame. */
export function createReadback(world: World): Pick<Emulator, 'readLayer' | 'readRoom' | 'readComposite' | 'counts'> {
  const presenting = (): { session: EmulatedSession; layer: NonNullable<ReturnType<typeof currentLayer>> } => {
    const layer = world.session && currentLayer(world.session);
    if (!world.session || !layer) throw new Error('There is no session with a layer to read.');
    return { session: world.session, layer };
  };
  const takeLayer = (): Pixels => {
    const { layer } = presenting();
    return turnRows(readLayer(layer), layer.target.widthPx, layer.target.heightPx);
  };
  const takeRoom = (): Pixels => {
    const { session, layer } = presenting();
    const { surroundings, eyes } = session[P_EMULATED];
    const { widthPx, heightPx } = layer.target;
    const rgba = new Uint8Array(widthPx * heightPx * 4);
    const { display } = world.settings;
    // On display the canvas holds both by now: draw the room again, and put the layer back.
    if (display) surroundings.view.drawRoom(session[P_SESSION].mode === 'immersive-ar' ? eyes : []);
    surroundings.view.readPixels(rgba);
    if (display) showLayer(session, layer);
    return turnRows(rgba, widthPx, heightPx);
  };
  return {
    readLayer: takeLayer,
    readRoom: takeRoom,
    readComposite: () => {
      const { session } = presenting();
      return compositePixels(takeLayer(), takeRoom(), session[P_SESSION].mode === 'immersive-ar' ? world.profile.blend : 'opaque');
    },
    counts: () => {
      const { memory, programs } = world.surroundings().view.renderer.info;
      return { geometries: memory.geometries, textures: memory.textures, programs: programs?.length ?? 0 };
    },
  };
}
