/** `data:TYPE;base64,…` or percent-encoded text (RFC 2397). */
export function decodeDataUrl(url: string): { bytes: Uint8Array<ArrayBuffer>; type: string } {
  const comma = url.indexOf(',');
  const [type = '', ...options] = url.slice('data:'.length, comma).split(';');
  const content = url.slice(comma + 1);
  const binary = options.includes('base64') ? atob(content) : decodeURIComponent(content);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return { bytes, type };
}
