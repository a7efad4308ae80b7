import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createGlLedger } from '../../export/runtime/gl/gl-ledger.ts';
import type { OwnedMemory } from '../../export/runtime/gl/owned-objects.ts';
import { createPlayer } from '../../export/runtime/player.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import { createGpuBytes } from '../../tools/bench/pages/gpu-bytes.ts';
import { createGl, frame } from './runtime-kit.ts';

export interface Followed {
  /** While the program plays, and after it was replaced by one without these nodes. */
  readonly owners: readonly OwnedMemory[];
  readonly after: readonly OwnedMemory[];
  /** What the textures and buffers of the context take in the first program more than in the second. */
  readonly bytes: number;
  readonly error: number;
}

/** A node that creates a texture in each frame and deletes none. */
const FORGETFUL: NodeModule = {
  create: ({ gl }) => ({
    update: () => {
      gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, 16, 16);
    },
    draw: () => {},
    dispose: () => {},
  }),
};

/** Plays a program until its files are loaded, then another one. Nodes of the type `forgetful` leave a texture per frame. */
export async function follow(program: Program, next: Program, assetUrl: string, forgetful: string | null): Promise<Followed> {
  const gl = createGl({ depth: true });
  const counted = createGpuBytes(gl);
  const ledger = createGlLedger(gl);
  const player = createPlayer({
    gl,
    canvas: gl.canvas as HTMLCanvasElement,
    program,
    modules: forgetful === null ? RUNTIMES : { ...RUNTIMES, [forgetful]: FORGETFUL },
    createScenes: null,
    assets: createFetchAssetSource(new URL(assetUrl, location.href).href, (...args) => fetch(...args)),
    seed: 1,
    onDiagnostics: () => {},
    owned: ledger,
  });
  await player.ready;
  player.setSession({ world: 'virtual', blend: 'opaque' } as never);
  await player.complete;
  for (let index = 0; index < 3; index++) player.draw(frame(index));
  const owners = ledger.owners();
  const bytes = counted.textures() + counted.buffers();
  await player.replaceProgram(next);
  player.draw(frame(3));
  const after = ledger.owners();
  const result = { owners, after, bytes: bytes - counted.textures() - counted.buffers(), error: gl.getError() };
  player.dispose();
  ledger.dispose();
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return result;
}
