/** Number of existing GPU objects that were created by one `GlObjects`. */
export interface GlCounts {
  readonly textures: number;
  readonly framebuffers: number;
  readonly renderbuffers: number;
  readonly programs: number;
  readonly shaders: number;
  readonly samplers: number;
  readonly vertexArrays: number;
  readonly buffers: number;
}

/**
 * Creates and deletes GPU objects and counts them. The player creates its own objects and those of assets with it. Nodes that draw themselves
 * use `gl`; `OwnedObjects` follows them.
 */
export interface GlObjects {
  readonly gl: WebGL2RenderingContext;
  readonly limits: GlLimits;
  createTexture(): WebGLTexture;
  deleteTexture(texture: WebGLTexture): void;
  createFramebuffer(): WebGLFramebuffer;
  deleteFramebuffer(framebuffer: WebGLFramebuffer): void;
  createRenderbuffer(): WebGLRenderbuffer;
  deleteRenderbuffer(renderbuffer: WebGLRenderbuffer): void;
  createProgram(): WebGLProgram;
  deleteProgram(program: WebGLProgram): void;
  createShader(type: GLenum): WebGLShader | null;
  deleteShader(shader: WebGLShader): void;
  createSampler(): WebGLSampler;
  deleteSampler(sampler: WebGLSampler): void;
  createVertexArray(): WebGLVertexArrayObject;
  deleteVertexArray(vertexArray: WebGLVertexArrayObject): void;
  createBuffer(): WebGLBuffer;
  deleteBuffer(buffer: WebGLBuffer): void;
  counts(): GlCounts;
}

/** Capabilities of the context, queried once, because each query is a round trip to the GPU process. */
export interface GlLimits {
  readonly maxTextureSizePx: number;
  readonly maxSamples: number;
  /** Whether 32-bit and 16-bit float textures can be rendered to. */
  readonly floatTargets: boolean;
  /** Whether 32-bit float textures can be filtered linearly. */
  readonly floatLinear: boolean;
  /** Whether 16-bit float textures can be rendered to, though perhaps not 32-bit ones. */
  readonly halfFloatTargets: boolean;
  /** The extension `KHR_parallel_shader_compile`; null if the browser lacks it. */
  readonly parallelCompile: KHR_parallel_shader_compile | null;
}

/** Kinds of objects, as functions of the context name them. */
const KINDS = ['Texture', 'Framebuffer', 'Renderbuffer', 'Program', 'Shader', 'Sampler', 'VertexArray', 'Buffer'] as const;

type Functions = Record<string, (argument?: unknown) => unknown>;

export function createGlObjects(gl: WebGL2RenderingContext): GlObjects {
  const context = gl as unknown as Functions;
  const functions: Functions = {};
  const counts: Record<string, number> = {};
  const count = (plural: string, change: number): void => {
    counts[plural] = (counts[plural] ?? 0) + change;
  };
  // Written out, the functions would take 80 bytes more of each page.
  for (const kind of KINDS) {
    const plural = `${kind.charAt(0).toLowerCase()}${kind.slice(1)}s`;
    count(plural, 0);
    functions[`create${kind}`] = (type) => {
      const object = context[`create${kind}`]?.(type);
      if (object !== null) count(plural, 1);
      return object;
    };
    functions[`delete${kind}`] = (object) => {
      count(plural, -1);
      context[`delete${kind}`]?.(object);
    };
  }
  const floatTargets = gl.getExtension('EXT_color_buffer_float') !== null;
  return {
    gl,
    limits: {
      maxTextureSizePx: gl.getParameter(gl.MAX_TEXTURE_SIZE) as number,
      maxSamples: gl.getParameter(gl.MAX_SAMPLES) as number,
      floatTargets,
      floatLinear: gl.getExtension('OES_texture_float_linear') !== null,
      halfFloatTargets: floatTargets || gl.getExtension('EXT_color_buffer_half_float') !== null,
      parallelCompile: gl.getExtension('KHR_parallel_shader_compile'),
    },
    ...functions,
    counts: () => ({ ...counts }),
  } as unknown as GlObjects;
}
