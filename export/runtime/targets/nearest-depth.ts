import type { LinkedShader } from '../../program/program.ts';
import { allocateTexture } from '../gl/allocate-texture.ts';
import { clearAll } from '../gl/clear.ts';
import { COPY_SHADER } from '../gl/copy-shader.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { GlProgram } from '../gl/program-cache.ts';

/**
 * Resolves the depth of multisampled targets to that of the nearest covered sample (docs/CONVENTIONS.md, “Depth at edges”).
 *
 * WebGL resolves depth by a blit, which takes one sample per pixel, and the other samples cannot be read. But a draw can test its depth
 * against each sample. A first pass draws one depth per pixel over the multisampled depth buffer, without writing depth, and so finds the
 * pixels with a nearer sample: if the sample of the blit is empty, any covered sample; if a neighboring pixel is nearer, a sample that is
 * nearer than midway to it. A second pass gives those pixels the depth of their nearest neighbor.
 *
 * Rejected: the nearest of 3 × 3 pixels without the test, which makes all things one pixel larger; depth as a second color, whose resolve
 * is a mean and whose memory is as large as that of the color; drawing the scene again at double size, which costs all vertices twice.
 */
export interface NearestDepth {
  /** Creates the buffers for a multisampled depth buffer of a size. */
  createResolve(depth: WebGLRenderbuffer, multisampled: WebGLFramebuffer, samples: number, widthPx: number, heightPx: number): DepthResolve;
}

/**
 * Creates the `NearestDepth` of a context.
 *
 * @param link Returns the program of a shader. It links the shader at its first use, and keeps the program.
 */
export type CreateNearestDepth = (objects: GlObjects, drawer: PassDrawer, link: (shader: LinkedShader) => GlProgram) => NearestDepth;

/** The resolve of one depth buffer. */
export interface DepthResolve {
  /** Window-space depth, 1 where no sample is covered. */
  readonly texture: WebGLTexture;
  /** Draws `texture`; binds framebuffers and disables the scissor test. */
  run(): void;
  dispose(): void;
}

/**
 * How much nearer a neighboring pixel must be to belong to another surface, relative to its own distance. Slopes of one surface stay below
 * this.
 */
const APART = 0.02;

const NEIGHBORS_TEXT = /* glsl */ `
precision highp float;
uniform highp sampler2D depth;
float own;
float nearest;
void readNeighbors() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(depth, 0) - 1;
  own = texelFetch(depth, here, 0).r;
  nearest = own;
  for (int i = 0; i < 9; i++) nearest = min(nearest, texelFetch(depth, clamp(here + ivec2(i % 3, i / 3) - 1, ivec2(0), last), 0).r);
}`;

// 1 - depth is proportional to 1 / distance but for the far plane, so the quotient compares distances. 2e-7 is three steps of 24 bits.
const FIND_SHADER: LinkedShader = {
  id: 'scrim:find-nearer-sample',
  vertex: COPY_SHADER.vertex,
  fragment: /* glsl */ `#version 300 es${NEIGHBORS_TEXT}
out vec4 isFound;
void main() {
  readNeighbors();
  bool isEmpty = own >= 1.0;
  if (!isEmpty && own - nearest < ${APART} * (1.0 - nearest)) discard;
  gl_FragDepth = isEmpty ? 1.0 - 2e-7 : mix(nearest, own, 0.5);
  isFound = vec4(1.0);
}
`,
};

const CHOOSE_SHADER: LinkedShader = {
  id: 'scrim:choose-nearer-sample',
  vertex: COPY_SHADER.vertex,
  fragment: /* glsl */ `#version 300 es${NEIGHBORS_TEXT}
uniform highp sampler2D found;
void main() {
  readNeighbors();
  gl_FragDepth = texelFetch(found, ivec2(gl_FragCoord.xy), 0).r > 0.0 ? nearest : own;
}
`,
};

/** Creates what resolves depth. Its programs are linked at the first use. */
export const createNearestDepth: CreateNearestDepth = (objects, drawer, link) => {
  const { gl } = objects;
  const draw = (shader: LinkedShader, depth: WebGLTexture, found: WebGLTexture | null): void => {
    const program = link(shader);
    drawer.use(program);
    bind(program.uniform('depth'), 0, depth);
    bind(program.uniform('found'), 1, found);
    drawer.draw();
  };
  const bind = (location: WebGLUniformLocation | null, unit: number, texture: WebGLTexture | null): void => {
    if (location) drawer.texture(unit, location, texture, 'nearest');
  };
  return {
    createResolve: (depth, multisampled, samples, widthPx, heightPx) => {
      const texture = (format: GLenum) => allocateTexture(gl, objects.createTexture(), format, gl.NEAREST, widthPx, heightPx);
      const framebuffer = (attachment: GLenum, image: WebGLTexture): WebGLFramebuffer => {
        const made = objects.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, made);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, image, 0);
        return made;
      };
      const one = texture(gl.DEPTH_COMPONENT24);
      const nearest = texture(gl.DEPTH_COMPONENT24);
      const found = texture(gl.R8);
      const intoOne = framebuffer(gl.DEPTH_ATTACHMENT, one);
      const intoNearest = framebuffer(gl.DEPTH_ATTACHMENT, nearest);
      const intoFound = framebuffer(gl.COLOR_ATTACHMENT0, found);
      const finding = objects.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, finding);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, gl.R8, widthPx, heightPx);
      const find = objects.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, find);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, finding);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
      const blit = (from: WebGLFramebuffer, to: WebGLFramebuffer, mask: GLenum): void => {
        gl.disable(gl.SCISSOR_TEST);
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to);
        gl.blitFramebuffer(0, 0, widthPx, heightPx, 0, 0, widthPx, heightPx, mask, gl.NEAREST);
      };
      return {
        texture: nearest,
        run: () => {
          blit(multisampled, intoOne, gl.DEPTH_BUFFER_BIT);
          clearAll(gl, find, false);
          drawer.begin(find, 0, 0, widthPx, heightPx, 'replace');
          gl.enable(gl.DEPTH_TEST);
          gl.depthFunc(gl.GEQUAL);
          gl.depthMask(false);
          draw(FIND_SHADER, one, null);
          blit(find, intoFound, gl.COLOR_BUFFER_BIT);
          drawer.begin(intoNearest, 0, 0, widthPx, heightPx, 'replace');
          gl.enable(gl.DEPTH_TEST);
          gl.depthFunc(gl.ALWAYS);
          gl.depthMask(true);
          draw(CHOOSE_SHADER, one, found);
          gl.disable(gl.DEPTH_TEST);
          gl.depthFunc(gl.LESS);
          drawer.end();
        },
        dispose: () => {
          for (const made of [intoOne, intoNearest, intoFound, find]) objects.deleteFramebuffer(made);
          for (const made of [one, nearest, found]) objects.deleteTexture(made);
          objects.deleteRenderbuffer(finding);
        },
      };
    },
  };
};
