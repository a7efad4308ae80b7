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

export function createGlObjects(gl: WebGL2RenderingContext): GlObjects {
  const counts = { textures: 0, framebuffers: 0, renderbuffers: 0, programs: 0, shaders: 0, samplers: 0, vertexArrays: 0, buffers: 0 };
  const count = <T>(kind: keyof GlCounts, object: T): T => {
    if (object !== null) counts[kind]++;
    return object;
  };
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
    createTexture: () => count('textures', gl.createTexture()),
    deleteTexture: (texture) => {
      counts.textures--;
      gl.deleteTexture(texture);
    },
    createFramebuffer: () => count('framebuffers', gl.createFramebuffer()),
    deleteFramebuffer: (framebuffer) => {
      counts.framebuffers--;
      gl.deleteFramebuffer(framebuffer);
    },
    createRenderbuffer: () => count('renderbuffers', gl.createRenderbuffer()),
    deleteRenderbuffer: (renderbuffer) => {
      counts.renderbuffers--;
      gl.deleteRenderbuffer(renderbuffer);
    },
    createProgram: () => count('programs', gl.createProgram()),
    deleteProgram: (program) => {
      counts.programs--;
      gl.deleteProgram(program);
    },
    createShader: (type) => count('shaders', gl.createShader(type)),
    deleteShader: (shader) => {
      counts.shaders--;
      gl.deleteShader(shader);
    },
    createSampler: () => count('samplers', gl.createSampler()),
    deleteSampler: (sampler) => {
      counts.samplers--;
      gl.deleteSampler(sampler);
    },
    createVertexArray: () => count('vertexArrays', gl.createVertexArray()),
    deleteVertexArray: (vertexArray) => {
      counts.vertexArrays--;
      gl.deleteVertexArray(vertexArray);
    },
    createBuffer: () => count('buffers', gl.createBuffer()),
    deleteBuffer: (buffer) => {
      counts.buffers--;
      gl.deleteBuffer(buffer);
    },
    counts: () => ({ ...counts }),
  };
}
