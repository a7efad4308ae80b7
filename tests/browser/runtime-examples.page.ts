import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { setRigidInverse } from '../../export/runtime/sessions/matrix.ts';
import { createOrbit, ORBIT_DEFAULTS } from '../../export/runtime/sessions/orbit/orbit-pose.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { createGl, frame, HEIGHT, pixel, stand, texture, view, WIDTH } from './runtime-kit.ts';

const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

export interface Played {
  readonly center: readonly number[];
  readonly corner: readonly number[];
  readonly diagnostics: readonly unknown[];
  readonly error: number;
}

/** Plays a compiled example over a camera picture of one color, in a room of one depth, looking at the origin from 1 m. */
export async function play(program: Program, assetUrl: string, timeS: number, camera: number[], roomM: number): Promise<Played> {
  const gl = createGl({ depth: true });
  const assets = createFetchAssetSource(new URL(assetUrl, location.href).href, (...args) => fetch(...args));
  const { player, diagnostics } = await stand(program, { gl, modules: RUNTIMES, createScenes, assets, held: true });
  const room = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, room);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, 1, 1, 0, gl.RED, gl.FLOAT, new Float32Array([roomM]));
  const seen = view(0, 0, WIDTH, HEIGHT, {
    cameraImage: { texture: texture(gl, 1, 1, camera), widthPx: 1, heightPx: 1, uvFromViewUv: UPRIGHT },
    depth: { texture: room, widthPx: 1, heightPx: 1, uvFromViewUv: UPRIGHT, worldFromDepth: new Float32Array(16) },
  });
  createOrbit({ ...ORBIT_DEFAULTS, targetWorld: [0, 0, 0], distanceM: 1, elevationRad: 0 }).writeWorldFromView(seen.worldFromView);
  setRigidInverse(seen.viewFromWorld, seen.worldFromView);
  player.setSession({ world: 'image', blend: 'opaque' });
  await player.drawSettled(frame(0, [seen], { timeS }));
  const result = {
    center: pixel(gl, WIDTH / 2, HEIGHT / 2),
    corner: pixel(gl, 1, 1),
    diagnostics: diagnostics(),
    error: gl.getError(),
  };
  player.dispose();
  return result;
}
