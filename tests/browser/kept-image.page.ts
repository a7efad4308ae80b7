import type { Eye } from '../../export/emulator/display/eye.ts';
import { createRoomView } from '../../export/emulator/display/room-view.ts';
import { createRoom } from '../../export/emulator/rooms/room-source.ts';
import { lookingAt } from './scenes-kit.ts';

const [WIDTH, HEIGHT] = [160, 60];

function eyesAt(x: number): Eye[] {
  return ['left', 'right'].map((name, i) => {
    const camera = lookingAt([x + i * 0.06, 1.6, 1], [0, 1, -2]);
    return {
      name: name as 'left' | 'right',
      clipFromView: Float32Array.from(camera.projectionMatrix.elements),
      worldFromView: Float32Array.from(camera.matrixWorld.elements),
      viewport: { x: (i * WIDTH) / 2, y: 0, widthPx: WIDTH / 2, heightPx: HEIGHT },
    };
  });
}

/** Images of the studio, and the triangles that the last call of each drew. */
export function images() {
  const room = createRoom('studio');
  const view = createRoomView(room, true, true);
  view.resize(WIDTH, HEIGHT);
  const shoot = (x: number) => {
    view.aimRoom(eyesAt(x));
    const rgba = new Uint8Array(WIDTH * HEIGHT * 4);
    view.readPixels(rgba);
    // What the page shows lies over the room, and does not stay there.
    view.drawLayer(new Uint8Array(WIDTH * HEIGHT * 4).fill(255), 'alpha-blend', 0);
    return rgba;
  };
  const drawnFor = (x: number) => {
    view.aimRoom(eyesAt(x));
    view.image();
    return view.renderer.info.render.triangles;
  };
  const still = [shoot(0), shoot(0), shoot(0), shoot(0)];
  const kept = drawnFor(0);
  const moved = shoot(0.5);
  const drawn = drawnFor(0.6);
  const back = shoot(0);
  shoot(0);
  room.moveLight([-0.8, 0.6, 0]);
  room.prepare?.(view.renderer, view.scene);
  view.roomChanged();
  const relit = shoot(0);
  view.dispose();
  room.dispose();
  return { still, kept, moved, drawn, back, relit };
}
