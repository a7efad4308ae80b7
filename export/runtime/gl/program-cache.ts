import type { LinkedShader } from '../../program/program.ts';
import type { GlObjects } from './gl-objects.ts';

/** A message of the driver about a shader that does not compile. The editor maps its lines through the shader's source map. */
export interface ShaderError {
  readonly shaderId: string;
  readonly stage: 'vertex' | 'fragment' | 'link';
  readonly log: string;
}

/** A GL program that may still be linking; shared by all passes with equal source. */
export interface GlProgram {
  readonly state: 'linking' | 'linked' | 'broken';
  /** The source that it was linked from. */
  readonly shader: LinkedShader;
  readonly program: WebGLProgram;
  /** Empty unless the state is `broken`. */
  readonly errors: readonly ShaderError[];
  /** The location of a uniform; null if the linked program has no such uniform. The location is queried once. */
  uniform(name: string): WebGLUniformLocation | null;
}

/**
 * Links GL programs without waiting and keeps each while it has users. Programs are identified by the hash of their source, so a recompiled
 * project reuses them.
 */
export interface ProgramCache {
  /** Starts linking for the first user. Each call needs a `release`. */
  acquire(shader: LinkedShader): GlProgram;
  release(program: GlProgram): void;
  /**
   * Updates the states. With `KHR_parallel_shader_compile` it never waits; otherwise it finishes one program per call, so that frames come
   * in between.
   */
  poll(): void;
  /** Waits until one program is linked or broken. This may block, so it is only for work outside of frames. */
  finish(program: GlProgram): void;
  dispose(): void;
}

export function createProgramCache(objects: GlObjects): ProgramCache {
  const entries = new Map<string, Entry>();
  return {
    acquire: (shader) => {
      let entry = entries.get(shader.id);
      if (!entry) {
        entry = new Entry(objects, shader);
        entries.set(shader.id, entry);
      }
      entry.users++;
      return entry;
    },
    release: (program) => {
      const entry = program as Entry;
      if (--entry.users > 0) return;
      entries.delete(entry.shader.id);
      entry.dispose();
    },
    poll: () => {
      const { parallelCompile } = objects.limits;
      for (const entry of entries.values()) {
        if (entry.state !== 'linking') continue;
        if (!parallelCompile) {
          entry.finish();
          return;
        }
        if (objects.gl.getProgramParameter(entry.program, parallelCompile.COMPLETION_STATUS_KHR)) entry.finish();
      }
    },
    finish: (program) => {
      if (program.state === 'linking') (program as Entry).finish();
    },
    dispose: () => {
      for (const entry of entries.values()) entry.dispose();
      entries.clear();
    },
  };
}

class Entry implements GlProgram {
  users = 0;
  state: 'linking' | 'linked' | 'broken' = 'linking';
  errors: readonly ShaderError[] = [];
  readonly program: WebGLProgram;
  private readonly stages: readonly { readonly stage: 'vertex' | 'fragment'; readonly shader: WebGLShader | null }[];
  private readonly uniforms = new Map<string, WebGLUniformLocation | null>();

  constructor(
    private readonly objects: GlObjects,
    readonly shader: LinkedShader,
  ) {
    const { gl } = objects;
    this.program = objects.createProgram();
    this.stages = [
      { stage: 'vertex', shader: this.compile(gl.VERTEX_SHADER, shader.vertex) },
      { stage: 'fragment', shader: this.compile(gl.FRAGMENT_SHADER, shader.fragment) },
    ];
    gl.linkProgram(this.program);
  }

  /** Updates the state with the result of linking; waits for the driver if necessary. */
  finish(): void {
    const { gl } = this.objects;
    // A lost context reports all programs as complete, without a meaning for the shader.
    if (gl.isContextLost()) return;
    if (gl.getProgramParameter(this.program, gl.LINK_STATUS)) {
      this.state = 'linked';
    } else {
      this.state = 'broken';
      this.errors = this.readErrors();
    }
    this.deleteShaders();
  }

  uniform(name: string): WebGLUniformLocation | null {
    let location = this.uniforms.get(name);
    if (location === undefined) {
      location = this.objects.gl.getUniformLocation(this.program, name);
      this.uniforms.set(name, location);
    }
    return location;
  }

  dispose(): void {
    this.deleteShaders();
    this.objects.deleteProgram(this.program);
  }

  private compile(type: GLenum, source: string): WebGLShader | null {
    const { gl } = this.objects;
    const shader = this.objects.createShader(type);
    if (shader) {
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
    }
    return shader;
  }

  private readErrors(): ShaderError[] {
    const { gl } = this.objects;
    const errors: ShaderError[] = [];
    for (const { stage, shader } of this.stages) {
      if (shader && !gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
        errors.push({ shaderId: this.shader.id, stage, log: gl.getShaderInfoLog(shader) ?? '' });
      }
    }
    if (errors.length > 0) return errors;
    return [{ shaderId: this.shader.id, stage: 'link', log: gl.getProgramInfoLog(this.program) ?? '' }];
  }

  private shadersLive = true;

  private deleteShaders(): void {
    if (!this.shadersLive) return;
    this.shadersLive = false;
    for (const { shader } of this.stages) if (shader) this.objects.deleteShader(shader);
  }
}
