// GLSL files are imported as text by esbuild, Vite and the test transform alike.
declare module '*.fs' {
  const text: string;
  export default text;
}
declare module '*.vs' {
  const text: string;
  export default text;
}
declare module '*.glsl' {
  const text: string;
  export default text;
}

// Vite puts the file beside the script, and gives its address.
declare module '*?url' {
  const url: string;
  export default url;
}

// Comes without types; its modules are handed to glTF-Transform as they are.
declare module 'draco3dgltf' {
  const draco3d: { createEncoderModule(): Promise<unknown> };
  export default draco3d;
}

// Comes without types. Options are objects of the library.
declare module '@mkkellogg/gaussian-splats-3d' {
  export const SceneRevealMode: { readonly Instant: number };
  export const PlyLoader: {
    loadFromFileData(file: ArrayBuffer, leastAlpha: number, compression: number, optimize: boolean, degree: number): Promise<unknown>;
  };
  export class Viewer {
    constructor(options: object);
    addSplatBuffers(buffers: readonly unknown[], options: readonly object[], isFinal: boolean, showsProgress: boolean): Promise<void>;
    update(): void;
    render(): void;
    dispose(): Promise<void>;
  }
}
