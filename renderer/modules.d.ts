// Vite takes styles that a component imports into the page's sheet.
declare module '*.css' {}
