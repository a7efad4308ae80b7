/** First line of all files that `npm run gen` writes. */
export const HEADER = '// Made by `npm run gen` from nodes/ and shader-library/; not committed. Change the folders, not this file.\n';
