/**
 * Writes texture UV from view UV, column-major 3×3, from WebXR's 4×4 `normDepthBufferFromNormView`, whose coordinates both start at the top
 * left (Depth Sensing §1.1). `firstRow` is the row of the buffer that the texture has at v = 0.
 */
export function setDepthUv(out: Float32Array, bufferFromView: Float32Array, firstRow: 'top' | 'bottom'): void {
  for (let row = 0; row < 3; row++) {
    // z is not used: rows and columns x, y, w of the 4×4.
    const from = row === 2 ? 3 : row;
    const x = bufferFromView[from] ?? 0;
    const y = bufferFromView[4 + from] ?? 0;
    const w = bufferFromView[12 + from] ?? 0;
    // View UV starts at the bottom left: y is 1 − v.
    out[row] = x;
    out[row + 3] = -y;
    out[row + 6] = y + w;
  }
  if (firstRow === 'top') return;
  for (let column = 0; column < 9; column += 3) out[column + 1] = (out[column + 2] ?? 0) - (out[column + 1] ?? 0);
}
