import { createTexelBytes, mipTexels } from '../../../export/runtime/gl/texel-bytes.ts';

/** Bytes of all textures and buffers of a context, updated as they are created and deleted. */
export interface GpuBytes {
  textures(): number;
  buffers(): number;
}

const TARGET_OF_FACE = (gl: WebGL2RenderingContext, target: number): number =>
  target >= gl.TEXTURE_CUBE_MAP_POSITIVE_X && target <= gl.TEXTURE_CUBE_MAP_NEGATIVE_Z ? gl.TEXTURE_CUBE_MAP : target;

/** Starts to count the bytes of a context. Must be called before the context creates objects. */
export function createGpuBytes(gl: WebGL2RenderingContext): GpuBytes {
  const texel = createTexelBytes(gl);
  /** Bytes of each texture, by face and level. */
  const textures = new Map<WebGLTexture, Map<string, number>>();
  const buffers = new Map<WebGLBuffer, number>();
  const bound = (target: number): WebGLTexture | null => {
    const all = TARGET_OF_FACE(gl, target);
    const query =
      all === gl.TEXTURE_CUBE_MAP
        ? gl.TEXTURE_BINDING_CUBE_MAP
        : all === gl.TEXTURE_3D
          ? gl.TEXTURE_BINDING_3D
          : all === gl.TEXTURE_2D_ARRAY
            ? gl.TEXTURE_BINDING_2D_ARRAY
            : gl.TEXTURE_BINDING_2D;
    return gl.getParameter(query) as WebGLTexture | null;
  };
  const note = (target: number, key: string, bytes: number): void => {
    const texture = bound(target);
    if (!texture) return;
    const parts = textures.get(texture) ?? new Map<string, number>();
    parts.set(key, bytes);
    textures.set(texture, parts);
  };
  after(gl, 'texImage2D', (args) => {
    const [target, level, format] = args as number[];
    const source = args.at(-1) as { width?: number; height?: number } | null;
    const [width, height] = args.length > 6 ? [args[3] as number, args[4] as number] : [source?.width ?? 0, source?.height ?? 0];
    note(target ?? 0, `${target}/${level}`, width * height * texel(format ?? 0));
  });
  after(gl, 'texStorage2D', ([target, levels, format, width, height]) => {
    const texels = mipTexels(levels as number, width as number, height as number);
    note(target as number, 'storage', texels * texel(format as number) * (target === gl.TEXTURE_CUBE_MAP ? 6 : 1));
  });
  after(gl, 'texStorage3D', ([target, levels, format, width, height, depth]) => {
    const texels = mipTexels(levels as number, width as number, height as number);
    note(target as number, 'storage', texels * (depth as number) * texel(format as number));
  });
  after(gl, 'texImage3D', ([target, level, format, width, height, depth]) =>
    note(target as number, `${level}`, (width as number) * (height as number) * (depth as number) * texel(format as number)),
  );
  after(gl, 'deleteTexture', ([texture]) => void textures.delete(texture as WebGLTexture));
  after(gl, 'bufferData', ([target, data]) => {
    const buffer = gl.getParameter(
      target === gl.ELEMENT_ARRAY_BUFFER
        ? gl.ELEMENT_ARRAY_BUFFER_BINDING
        : target === gl.UNIFORM_BUFFER
          ? gl.UNIFORM_BUFFER_BINDING
          : gl.ARRAY_BUFFER_BINDING,
    ) as WebGLBuffer | null;
    if (buffer) buffers.set(buffer, typeof data === 'number' ? data : ((data as ArrayBufferView | null)?.byteLength ?? 0));
  });
  after(gl, 'deleteBuffer', ([buffer]) => void buffers.delete(buffer as WebGLBuffer));
  const sum = (values: Iterable<number>): number => [...values].reduce((total, value) => total + value, 0);
  return {
    textures: () => sum([...textures.values()].map((parts) => sum(parts.values()))),
    buffers: () => sum(buffers.values()),
  };
}

function after(gl: WebGL2RenderingContext, name: keyof WebGL2RenderingContext, hear: (args: readonly unknown[]) => void): void {
  const object = gl as unknown as Record<string, (...args: readonly unknown[]) => unknown>;
  const former = object[name]?.bind(gl);
  object[name] = (...args) => {
    const result = former?.(...args);
    hear(args);
    return result;
  };
}
