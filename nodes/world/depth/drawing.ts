import { linkProgram } from '../../kit/link-program.ts';
import { setPassState, setSampler } from '../../kit/pass-state.ts';

/**
 * Draws full-screen passes over depth textures, in meters. The passes set all state that they depend on and leave no sampler bound, because
 * other code uses the same context.
 */
export interface DepthDrawing {
  /** Creates a texture, all 0. `meters`: depth in the red channel, 0 where unknown; `gray`: opaque shades of gray, RGBA8. */
  createImage(widthPx: number, heightPx: number, content?: 'meters' | 'gray'): DepthImage;
  free(image: DepthImage): void;
  /** Creates a pass from a fragment shader; the samplers get texture units in their order. The same text returns the same pass. */
  link(fragment: string, samplers: readonly string[]): DepthPass;
  /** Activates a pass; textures and uniforms that are set until `draw` belong to it. */
  begin(target: DepthImage, pass: DepthPass): void;
  texture(unit: number, texture: WebGLTexture | null, filter: 'linear' | 'nearest'): void;
  draw(): void;
  dispose(): void;
}

export interface DepthImage {
  readonly texture: WebGLTexture;
  readonly framebuffer: WebGLFramebuffer;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** An image that is created anew when it is needed in another size; this does not keep its content. */
export interface SizedImage {
  in(widthPx: number, heightPx: number): DepthImage;
  free(): void;
}

export interface DepthPass {
  readonly program: WebGLProgram;
  readonly samplers: readonly (WebGLUniformLocation | null)[];
  /** Looks up a uniform of the pass. Call it once per name, not in every frame. */
  uniform(name: string): WebGLUniformLocation | null;
}

/** Creates the drawing. Returns null if the GPU does not support float render targets. */
export function createDepthDrawing(gl: WebGL2RenderingContext): DepthDrawing | null {
  // Half floats resolve 1 mm at 1 m and 4 mm at 4 m, similar to the sensors.
  const format = gl.getExtension('EXT_color_buffer_float') ? gl.R32F : gl.getExtension('EXT_color_buffer_half_float') ? gl.R16F : null;
  if (format === null) return null;
  const vertexArray = gl.createVertexArray();
  const samplers = { linear: createSampler(gl, gl.LINEAR), nearest: createSampler(gl, gl.NEAREST) };
  const passes = new Map<string, DepthPass>();
  const images = new Set<DepthImage>();
  let units = 0;

  const free = (image: DepthImage): void => {
    gl.deleteTexture(image.texture);
    gl.deleteFramebuffer(image.framebuffer);
    images.delete(image);
  };
  return {
    createImage: (widthPx, heightPx, content = 'meters') => {
      const image = { texture: gl.createTexture(), framebuffer: gl.createFramebuffer(), widthPx, heightPx };
      images.add(image);
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, image.texture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, content === 'gray' ? gl.RGBA8 : format, widthPx, heightPx);
      // Readers that use three.js bind no sampler, so the texture needs these parameters.
      for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
      for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
      gl.bindFramebuffer(gl.FRAMEBUFFER, image.framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, image.texture, 0);
      return image;
    },
    free,
    link: (fragment, names) => {
      const pass = passes.get(fragment) ?? createPass(gl, fragment, names);
      passes.set(fragment, pass);
      return pass;
    },
    begin: (target, { program, samplers: locations }) => {
      setPassState(gl, target.framebuffer, vertexArray, 0, 0, target.widthPx, target.heightPx);
      gl.useProgram(program);
      for (let unit = 0; unit < locations.length; unit++) gl.uniform1i(locations[unit] ?? null, unit);
    },
    texture: (unit, texture, filter) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.bindSampler(unit, samplers[filter]);
      if (unit >= units) units = unit + 1;
    },
    draw: () => {
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      for (let unit = 0; unit < units; unit++) gl.bindSampler(unit, null);
      units = 0;
      gl.bindVertexArray(null);
    },
    dispose: () => {
      for (const image of images) free(image);
      for (const { program } of passes.values()) gl.deleteProgram(program);
      gl.deleteSampler(samplers.linear);
      gl.deleteSampler(samplers.nearest);
      gl.deleteVertexArray(vertexArray);
    },
  };
}

export function createSizedImage(drawing: DepthDrawing, content?: 'meters' | 'gray'): SizedImage {
  let image: DepthImage | null = null;
  const free = (): void => {
    if (image) drawing.free(image);
    image = null;
  };
  return {
    in: (widthPx, heightPx) => {
      if (image?.widthPx !== widthPx || image.heightPx !== heightPx) free();
      image ??= drawing.createImage(widthPx, heightPx, content);
      return image;
    },
    free,
  };
}

function createSampler(gl: WebGL2RenderingContext, filter: GLenum): WebGLSampler {
  const sampler = gl.createSampler();
  setSampler(gl, sampler, filter);
  return sampler;
}

/** The vertex shader of all passes: `uv` is (0, 0) at the bottom left and (1, 1) at the top right. */
const VERTEX = /* glsl */ `#version 300 es
out vec2 uv;
void main() {
  uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
`;

/**
 * The start of each fragment shader. A pass adds the function `float meters()`, which returns the depth, or the shade of gray, to write.
 */
const FRAGMENT_HEAD = /* glsl */ `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
in vec2 uv;
layout(location = 0) out vec4 color;
vec2 place(mat3 transform, vec2 at) {
  vec3 placed = transform * vec3(at, 1.0);
  return placed.xy / placed.z;
}
// Typical error of depth sensors at a distance, meters.
float strayM(float m) { return 0.01 + 0.005 * m; }
bool isInside(vec2 at) { return all(lessThanEqual(abs(at - 0.5), vec2(0.50001))); }
`;

function createPass(gl: WebGL2RenderingContext, fragment: string, samplers: readonly string[]): DepthPass {
  const program = linkProgram(gl, VERTEX, `${FRAGMENT_HEAD}${fragment}\nvoid main() { color = vec4(vec3(meters()), 1.0); }\n`);
  return {
    program,
    samplers: samplers.map((name) => gl.getUniformLocation(program, name)),
    uniform: (name) => gl.getUniformLocation(program, name),
  };
}
