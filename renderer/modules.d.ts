// Vite takes styles that a component imports into the page's sheet.
declare module '*.css' {}

// Parts of Monaco that are there for what importing them does.
declare module 'monaco-editor/editor/contrib/*' {}
