/** Whether a file is an image in AVIF: its first box names the brand (ISO 14496-12). */
export function isAvif(file: Uint8Array): boolean {
  return String.fromCharCode(...file.subarray(4, 12)) === 'ftypavif';
}

export function isJpeg(file: Uint8Array): boolean {
  return file[0] === 0xff && file[1] === 0xd8;
}

export function isPng(file: Uint8Array): boolean {
  return file[0] === 0x89 && file[1] === 0x50;
}
