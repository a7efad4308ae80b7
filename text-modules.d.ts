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
