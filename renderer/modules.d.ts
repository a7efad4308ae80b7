// Vite adds imported styles to the style sheet of the page.
declare module '*.css' {}

// Monaco modules that are imported for their side effects.
declare module 'monaco-editor/editor/contrib/*' {}
