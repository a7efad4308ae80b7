import type { GlObjects } from '../gl/gl-objects.ts';
import type { DepthResolve, NearestDepth } from './nearest-depth.ts';

/**
 * Creates multisampled buffers. A target needs its samples only while it is drawn: then they are resolved to its texture, which is a fifth
 * of their size. So buffers of equal size and format share their samples, which contain what was drawn last.
 */
export interface Multisampling {
  /** @param ownSamples Whether no other buffer draws into its samples. */
  createBuffer(format: BufferFormat, ownSamples: boolean): MultisampledBuffer;
}

export interface BufferFormat {
  readonly internal: GLenum;
  readonly withDepth: boolean;
  readonly samples: number;
  readonly widthPx: number;
  readonly heightPx: number;
}

export interface MultisampledBuffer {
  /** The framebuffer to draw to. */
  readonly framebuffer: WebGLFramebuffer;
  /** Resolves the color to a framebuffer. Binds framebuffers and disables the scissor test. */
  resolve(into: WebGLFramebuffer): void;
  /** Draws the depth if `resolve` was called since; see `TargetBuffer.readDepth`. */
  readDepth(): WebGLTexture | null;
  dispose(): void;
}

/** A renderbuffer with samples of one format and size. */
interface Samples {
  readonly renderbuffer: WebGLRenderbuffer;
  /** Gives it back. It is deleted when all that took it have given it back. */
  release(): void;
}

export function createMultisampling(objects: GlObjects, nearest: NearestDepth): Multisampling {
  const { gl } = objects;
  const shared = new Map<string, { readonly renderbuffer: WebGLRenderbuffer; users: number }>();
  let ownCount = 0;

  function take(internal: GLenum, { samples, widthPx, heightPx }: BufferFormat, own: boolean): Samples {
    const key = `${internal} ${samples} ${widthPx} ${heightPx}${own ? ` ${ownCount++}` : ''}`;
    const known = shared.get(key);
    const entry = known ?? { renderbuffer: objects.createRenderbuffer(), users: 0 };
    if (!known) {
      shared.set(key, entry);
      gl.bindRenderbuffer(gl.RENDERBUFFER, entry.renderbuffer);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, internal, widthPx, heightPx);
    }
    entry.users++;
    return {
      renderbuffer: entry.renderbuffer,
      release: () => {
        entry.users--;
        if (entry.users > 0) return;
        shared.delete(key);
        objects.deleteRenderbuffer(entry.renderbuffer);
      },
    };
  }

  return {
    createBuffer: (format, ownSamples) => {
      const { internal, withDepth, samples, widthPx, heightPx } = format;
      const framebuffer = objects.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      const attach = (attachment: GLenum, storage: GLenum): Samples => {
        const taken = take(storage, format, ownSamples);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, taken.renderbuffer);
        return taken;
      };
      const color = attach(gl.COLOR_ATTACHMENT0, internal);
      const depth = withDepth ? attach(gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24) : null;
      let depthResolve: DepthResolve | null = null;
      let isDepthStale = true;
      return {
        framebuffer,
        resolve: (into) => {
          isDepthStale = true;
          // The scissor test also limits a blit.
          gl.disable(gl.SCISSOR_TEST);
          gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
          gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, into);
          gl.blitFramebuffer(0, 0, widthPx, heightPx, 0, 0, widthPx, heightPx, gl.COLOR_BUFFER_BIT, gl.NEAREST);
        },
        readDepth: () => {
          if (!depth) return null;
          depthResolve ??= nearest.createResolve(depth.renderbuffer, framebuffer, samples, widthPx, heightPx);
          if (isDepthStale) depthResolve.run();
          isDepthStale = false;
          return depthResolve.texture;
        },
        dispose: () => {
          objects.deleteFramebuffer(framebuffer);
          color.release();
          depth?.release();
          depthResolve?.dispose();
        },
      };
    },
  };
}
