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
